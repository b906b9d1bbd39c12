package sunbeam.app;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.core.domain.AccessTarget.CodeUnitAccessTarget;
import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.text.DateFormat;
import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.text.MessageFormat;
import java.text.NumberFormat;
import java.text.SimpleDateFormat;
import java.time.format.DateTimeFormatter;
import java.util.Formatter;
import java.util.Locale;
import java.util.Map;
import java.util.Scanner;
import java.util.Set;

/**
 * Digits and letters that programs read are the same in every country: each call that knows locales is told which. The
 * entry point alone sets the default, for libraries.
 */
@AnalyzeClasses(
        packages = {"sunbeam", "jrtr"},
        importOptions = ImportOption.DoNotIncludeTests.class)
final class LocaleRulesTest {
    private static final String CONSTRUCTOR = "<init>";

    /** What follows the default unless it is told a locale, or symbols of one. */
    private static final Map<Class<?>, Set<String>> FOLLOWERS = Map.ofEntries(
            Map.entry(String.class, Set.of("format", "formatted", "toLowerCase", "toUpperCase")),
            Map.entry(PrintStream.class, Set.of("format", "printf")),
            Map.entry(PrintWriter.class, Set.of("format", "printf")),
            Map.entry(Formatter.class, Set.of(CONSTRUCTOR)),
            Map.entry(Scanner.class, Set.of(CONSTRUCTOR)),
            Map.entry(DecimalFormat.class, Set.of(CONSTRUCTOR)),
            Map.entry(DecimalFormatSymbols.class, Set.of(CONSTRUCTOR, "getInstance")),
            Map.entry(SimpleDateFormat.class, Set.of(CONSTRUCTOR)),
            Map.entry(MessageFormat.class, Set.of(CONSTRUCTOR, "format")),
            Map.entry(
                    NumberFormat.class,
                    Set.of("getInstance", "getNumberInstance", "getIntegerInstance", "getPercentInstance")),
            Map.entry(DateFormat.class, Set.of("getInstance", "getDateInstance", "getTimeInstance")),
            Map.entry(DateTimeFormatter.class, Set.of("ofPattern", "ofLocalizedDate", "ofLocalizedDateTime")),
            Map.entry(Locale.class, Set.of("getDefault")));

    @ArchTest
    static final ArchRule everyFormatIsToldItsLocale = noClasses()
            .should()
            .accessTargetWhere(describe("follows the default locale", LocaleRulesTest::followsTheDefault));

    @ArchTest
    static final ArchRule onlyTheEntryPointSetsTheDefault = noClasses()
            .that()
            .doNotHaveFullyQualifiedName("sunbeam.app.Main")
            .should()
            .accessTargetWhere(describe("sets the default locale", LocaleRulesTest::setsTheDefault));

    private static boolean followsTheDefault(JavaAccess<?> access) {
        JavaClass owner = access.getTargetOwner();
        String name = access.getTarget().getName();
        return access.getTarget() instanceof CodeUnitAccessTarget target
                && target.getRawParameterTypes().stream().noneMatch(LocaleRulesTest::tells)
                && FOLLOWERS.entrySet().stream()
                        .anyMatch(entry -> owner.isAssignableTo(entry.getKey())
                                && entry.getValue().contains(name));
    }

    private static boolean tells(JavaClass parameter) {
        return parameter.isEquivalentTo(Locale.class) || parameter.isEquivalentTo(DecimalFormatSymbols.class);
    }

    private static boolean setsTheDefault(JavaAccess<?> access) {
        return access.getTargetOwner().isEquivalentTo(Locale.class)
                && access.getTarget().getName().equals("setDefault");
    }
}
