package sunbeam.app;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideOutsideOfPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.AccessTarget.CodeUnitAccessTarget;
import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.library.dependencies.SlicesRuleDefinition;
import java.text.DecimalFormatSymbols;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Stream;

/** The layers of docs/architecture.md: app on top of precompute and jrtr, which do not know each other; and locales. */
@AnalyzeClasses(
        packages = {"sunbeam", "jrtr"},
        importOptions = ImportOption.DoNotIncludeTests.class)
final class LayersTest {
    /** What images need of java.awt without opening a window. */
    private static final Set<String> IMAGE_CLASSES =
            Set.of("java.awt.Point", "java.awt.Rectangle", "java.awt.Transparency");

    private static ArchRule unknown(DescribedPredicate<JavaClass> classes, String... packages) {
        return noClasses().that(classes).should().dependOnClassesThat().resideInAnyPackage(packages);
    }

    @ArchTest
    static final ArchRule precomputeKnowsNoGraphics = unknown(
            resideInAPackage("sunbeam.precompute.."), "jrtr..", "com.jogamp..", "sunbeam.app..", "javax.swing..");

    @ArchTest
    static final ArchRule engineKnowsNothingOfDiffraction = unknown(resideInAPackage("jrtr.."), "sunbeam..");

    @ArchTest
    static final ArchRule onlyTheEngineTouchesOpenGl =
            unknown(resideOutsideOfPackage("jrtr.gl.."), "com.jogamp..", "jogamp..");

    @ArchTest
    static final ArchRule onlyTheCommandLineKnowsPicocli =
            unknown(resideOutsideOfPackage("sunbeam.app.cli.."), "picocli..");

    @ArchTest
    static final ArchRule precomputeOpensNoWindows = noClasses()
            .that()
            .resideInAPackage("sunbeam.precompute..")
            .should()
            .dependOnClassesThat(describe("belong to AWT's windows", LayersTest::belongsToWindows));

    /** Each package by itself, so that a module's root package counts too. */
    @ArchTest
    static final ArchRule noCycles =
            SlicesRuleDefinition.slices().matching("(**)").should().beFreeOfCycles();

    /** docs/architecture.md draws the arrows between the rooms of the application. */
    @ArchTest
    static final ArchRule noCyclesBetweenRooms =
            SlicesRuleDefinition.slices().matching("sunbeam.app.(*)..").should().beFreeOfCycles();

    /** jrtr.gl.DisplayFaults keeps what JOGL itself prints off the stream; it prints nothing of its own. */
    @ArchTest
    static final ArchRule onlyTheEntryPointAndProgressKnowTheStandardStreams = noClasses()
            .that(outsideOf(
                    Set.of("sunbeam.app.Main", "sunbeam.app.terminal.ProgressDisplay", "jrtr.gl.DisplayFaults")))
            .should()
            .accessField(System.class, "out")
            .orShould()
            .accessField(System.class, "err");

    @ArchTest
    static final ArchRule onlyTheEntryPointEndsTheProcess = noClasses()
            .that(outsideOf(Set.of("sunbeam.app.Main")))
            .should()
            .callMethod(System.class, "exit", int.class);

    private static boolean belongsToWindows(JavaClass type) {
        String packageName = type.getPackageName();
        boolean ofImages = packageName.startsWith("java.awt.image")
                || packageName.equals("java.awt.color")
                || IMAGE_CLASSES.contains(type.getName());
        return packageName.startsWith("java.awt") && !ofImages;
    }

    private static DescribedPredicate<JavaClass> outsideOf(Set<String> names) {
        return describe("are not " + names, type -> !names.contains(type.getName()));
    }

    // Digits and letters that programs read are the same in every country: each call that knows locales is told which.
    // The entry point alone sets the default, for libraries.

    /** Methods that follow the default unless they are told a locale, or symbols of one. */
    private static final Set<String> FOLLOWERS = Set.of(("String.format String.formatted String.toLowerCase"
                    + " String.toUpperCase PrintStream.format PrintStream.printf PrintWriter.format PrintWriter.printf"
                    + " Formatter.<init> Scanner.<init> DecimalFormat.<init> DecimalFormatSymbols.<init>"
                    + " DecimalFormatSymbols.getInstance SimpleDateFormat.<init> MessageFormat.<init>"
                    + " MessageFormat.format NumberFormat.getInstance NumberFormat.getNumberInstance"
                    + " NumberFormat.getIntegerInstance NumberFormat.getPercentInstance DateFormat.getInstance"
                    + " DateFormat.getDateInstance DateFormat.getTimeInstance DateTimeFormatter.ofPattern"
                    + " DateTimeFormatter.ofLocalizedDate DateTimeFormatter.ofLocalizedDateTime Locale.getDefault")
            .split(" ", -1));

    @ArchTest
    static final ArchRule everyFormatIsToldItsLocale = noClasses()
            .should()
            .accessTargetWhere(describe("follows the default locale", LayersTest::followsTheDefault));

    @ArchTest
    static final ArchRule onlyTheEntryPointSetsTheDefault = noClasses()
            .that(outsideOf(Set.of("sunbeam.app.Main")))
            .should()
            .accessTargetWhere(describe("sets the default locale", LayersTest::setsTheDefault));

    private static boolean followsTheDefault(JavaAccess<?> access) {
        JavaClass owner = access.getTargetOwner();
        String method = "." + access.getTarget().getName();
        return access.getTarget() instanceof CodeUnitAccessTarget target
                && target.getRawParameterTypes().stream().noneMatch(LayersTest::tells)
                && Stream.concat(Stream.of(owner), owner.getAllRawSuperclasses().stream())
                        .anyMatch(type -> FOLLOWERS.contains(type.getSimpleName() + method));
    }

    private static boolean tells(JavaClass parameter) {
        return parameter.isEquivalentTo(Locale.class) || parameter.isEquivalentTo(DecimalFormatSymbols.class);
    }

    private static boolean setsTheDefault(JavaAccess<?> access) {
        return access.getTargetOwner().isEquivalentTo(Locale.class)
                && access.getTarget().getName().equals("setDefault");
    }
}
