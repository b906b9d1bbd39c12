package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;
import sunbeam.acceptance.ValueCommand.Known;
import sunbeam.app.cli.PatchOptions;
import sunbeam.app.cli.SettingOptions;
import sunbeam.app.scene.Scene;
import sunbeam.app.scene.SceneMethod;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.scene.Scenes;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.app.viewer.PickedLight;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.optics.Direction;
import sunbeam.precompute.optics.DirectionPair;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/** Every command that knows a quantity of {@code reflectance} has its value, under every setting that both accept. */
class SameQuantityTest extends InOneWorkplace {
    private static final String PATCH = "grating.txt --width 1.2um --height 200nm --height-unit nm --periodic --force ";
    static final String WINDOW = "--coherence-length 5um ";
    private static final Pattern OPTION = Pattern.compile("--[a-z][a-z-]*");

    /** Settings together, of which a command gets those that it has. */
    private static final List<String> CASES = List.of(
            WINDOW + "--average ensemble --tolerance 1e-3",
            WINDOW + "--average coherent --preset thesis --terms 20 --expansion taylor --radius 2 --anchor nearest"
                    + " --wavelength-step 10nm",
            WINDOW + "--average coherent --fresnel squared --window-origin corner --illuminant A --observer cie1964"
                    + " --wavelengths 450nm..650nm --index 3 --tolerance 1e-3",
            WINDOW + "--average ensemble --index 0.97+6.5i --rotate-patch 20deg --tolerance 1e-3",
            WINDOW + "--average ensemble --energy conserve --tolerance 1e-3",
            WINDOW + "--method nmm --average ensemble --fresnel squared --index n.csv --tolerance 1e-3",
            WINDOW + "--method table --average ensemble --index 2 --tolerance 1e-3",
            WINDOW + "--method gem --spacing 1.2um --orders 3 --gem-form stam --fresnel squared --index 2",
            "--method pq --replicas 5 --interpolation sinc --fresnel squared --index 2",
            "--method reference --replicas 5",
            WINDOW + "--method reference --average coherent --window-origin corner",
            WINDOW + "--method reference --average ensemble --preset thesis");

    /** Settings of another quantity: no list of directions has a lamp's width (LampCertificateTest). */
    private static final Set<Setting<?>> NONE = Set.of(SceneSettings.ANGULAR_DIAMETER);

    @BeforeAll
    static void writeGrating() throws IOException {
        String row = IntStream.range(0, 48)
                .mapToObj(i -> String.format(
                        Locale.ROOT,
                        "%.3f",
                        60 * Math.sin(2 * Math.PI * i / 48) + 25 * Math.sin(4 * Math.PI * i / 48 + 1)))
                .collect(Collectors.joining(" "));
        Files.write(workplace.resolve("even.txt"), Collections.nCopies(8, row));
        // Half of the rows are scanned a step higher.
        String higher = Arrays.stream(row.split(" ", -1))
                .map(height -> String.format(Locale.ROOT, "%.3f", Double.parseDouble(height) + 30))
                .collect(Collectors.joining(" "));
        List<String> rows = new ArrayList<>(Collections.nCopies(4, row));
        rows.addAll(Collections.nCopies(4, higher));
        Files.write(workplace.resolve("grating.txt"), rows);
        Files.writeString(workplace.resolve("n.csv"), "wl,n,k\n0.35,0.9,1.7\n0.5,0.8,2.6\n0.65,0.3,3.3\n0.85,0.2,5\n");
    }

    @Test
    void everySettingOfAMethodHasACase() {
        Set<String> given = options(String.join(" ", CASES));
        List<Setting<?>> settings = new ArrayList<>(Methods.SETTINGS);
        settings.addAll(List.of(SceneSettings.ENERGY, SceneSettings.ROTATE_PATCH, SceneSettings.ANGULAR_DIAMETER));
        settings.removeAll(NONE);
        assertThat(given)
                .contains("--index")
                .containsAll(settings.stream().map(OptionOrigin.INSTANCE::name).toList());
    }

    /** Of a sample and an export, which take seconds, reflectance has only window and tolerance. */
    private static List<String> cases(ValueCommand command) {
        return switch (command) {
            case SAMPLE -> CASES.subList(0, 1);
            case EXPORT -> List.of(WINDOW + "--tolerance 1e-2");
            default -> CASES;
        };
    }

    @ParameterizedTest
    @EnumSource
    void commandsAgree(ValueCommand command) throws IOException {
        Set<String> accepted = accepted(command.label());
        Set<String> ofList = accepted("reflectance");
        Set<String> compared = new HashSet<>();
        for (String options : cases(command)) {
            String both = kept(options, accepted, ofList);
            if (compared.contains(both)) {
                continue;
            }
            SubjectResult result = subject(command, both);
            if (result.isRefused) {
                continue;
            }
            List<double[]> rows = result.known.stream().map(Known::row).toList();
            String own = (command.ofList() + " " + both).strip();
            CsvFile.ofDirections(rows).write(workplace.resolve("list.csv"));
            SunbeamResult listed =
                    workplace.here("reflectance " + PATCH + own + " --directions list.csv --output out.csv");
            if (listed.exitCode() == 2) {
                continue;
            }
            listed.ended(0);
            compare(command, both, result.known, CsvFile.read(workplace.resolve("out.csv")));
            compared.add(both);
        }
        assertThat(compared).as("settings of %s", command).isNotEmpty();
    }

    /** The viewer computes the light of a picked point in its process, by direct sums; so does method reference. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "--average ensemble",
                "--average coherent --illuminant A --observer cie1964 --wavelengths 450nm..650nm",
                "--method pq --replicas 5",
                "--energy conserve"
            })
    void aPickHasTheLightOfReflectance(String options) throws IOException {
        Scene scene = scene(options);
        String[] words = PATCH.replace("--force ", "").split(" ");
        words[0] = workplace.resolve(words[0]).toString();
        Patch patch = CommandLine.populateCommand(new PatchOptions(), words).load(Choices.none());
        double[][] rows = {{40, 10, 39, -170, 500}, {40, 10, 5, 3, 600}, {40, 10, 60, 80, 700}};
        // A pick is not divided by wavelength as rho is, and its colors are.
        boolean isDivided = options.contains("energy");
        String method = isDivided
                ? "--method full --average ensemble --tolerance 1e-5 "
                : options.contains("pq") ? "--method reference --replicas 5 " : "--method reference ";
        String own = options.contains("pq") ? "" : WINDOW + options;
        for (int columns : new int[] {5, 4}) {
            CsvFile.ofDirections(Arrays.stream(rows)
                            .map(row -> Arrays.copyOf(row, columns))
                            .toList())
                    .write(workplace.resolve("list.csv"));
            workplace.succeedHere(
                    "reflectance " + PATCH + (method + own).strip() + " --directions list.csv --output out.csv");
            CsvFile listed = CsvFile.read(workplace.resolve("out.csv"));
            for (int i = 0; i < rows.length; i++) {
                PickedLight pick = PickedLight.of(scene, patch, pair(rows[i]));
                double[] known = columns == 5 ? new double[] {pick.power(1e-9 * rows[i][4])} : pick.xyz();
                double[] expected = columns == 5 ? new double[] {listed.at(i, "power")} : ValueCommand.xyz(listed, i);
                // Accuracy of the pick's quadrature, or method full's tolerance.
                assertThat(known)
                        .as("%s, row %d", options, i)
                        .containsExactly(
                                expected,
                                within((isDivided ? 1e-5 : 1e-6)
                                        * Arrays.stream(expected).max().orElseThrow()));
            }
        }
    }

    /** An export's divisor at a band's middle is that of a list at this wavelength, for light at a node of the divisor's grid. */
    @Test
    void anExportOfSpectraHasTheDivisorOfReflectance() throws IOException {
        // A step between rows takes the light of orders that cannot leave.
        String even = PATCH.replace("grating", "even");
        workplace.succeedHere("export " + even + WINDOW + "--energy conserve --format npz --channels spectral --bands 3"
                + " --size 500KB --tolerance 0.1 --samples 0 --output known.npz");
        int side = 25;
        float[] divisors = ValueCommand.arrays(workplace, "divisor").get(0);
        int bands = 3;
        double most = 1;
        CsvFile.ofDirections(IntStream.range(0, bands)
                        .mapToObj(i -> new double[] {30, 0, 25, 180, 380 + 200 * i})
                        .toList())
                .write(workplace.resolve("list.csv"));
        List<CsvFile> both = new ArrayList<>();
        for (String energy : List.of("scalar", "conserve")) {
            workplace.succeedHere("reflectance " + even + WINDOW + "--average ensemble --tolerance 1e-3 --energy "
                    + energy + " --directions list.csv --output out.csv");
            both.add(CsvFile.read(workplace.resolve("out.csv")));
        }
        for (int band = 0; band < bands; band++) {
            // Sine 0.5 is node 18 of 0 to 24, and 0 node 12.
            double divisor = divisors[band * side * side + 12 * side + 18];
            // Values are float32.
            assertThat(both.get(0).at(band, "brdf") / both.get(1).at(band, "brdf"))
                    .isCloseTo(divisor, within(1e-6 * divisor));
            most = Math.max(most, divisor);
        }
        assertThat(most).as("a divisor that does something").isGreaterThan(1.01);
    }

    private static Scene scene(String options) {
        SettingOptions settings = CommandLine.populateCommand(
                new SettingOptions(Setting.union(Methods.SETTINGS, List.of(SceneSettings.ENERGY))),
                ((options.contains("pq") ? "" : WINDOW) + options).strip().split(" "));
        Choices choices = settings.choices();
        return Scenes.load("light-above")
                .withMethod(new SceneMethod(choices))
                .with(choices.only(List.of(SceneSettings.ENERGY)));
    }

    private static DirectionPair pair(double[] row) {
        return new DirectionPair(Direction.ofDegrees(row[0], row[1]), Direction.ofDegrees(row[2], row[3]));
    }

    private record SubjectResult(boolean isRefused, List<Known> known) {}

    /** A combination that the command refuses by name is no case. */
    private static SubjectResult subject(ValueCommand command, String options) throws IOException {
        SunbeamResult result =
                workplace.here((command.label() + " " + PATCH + options).strip() + " " + command.words());
        if (result.exitCode() == 2) {
            return new SubjectResult(true, List.of());
        }
        // Code 3 says that no view has a color.
        assertThat(result.exitCode()).as("%s", result).isIn(0, 3);
        return new SubjectResult(false, command.read(workplace));
    }

    private static void compare(ValueCommand command, String options, List<Known> known, CsvFile listed) {
        // One function computes both, in float32, whose sums err relative to the brightest. Colors of a table have its
        // tolerance.
        double relative = command == ValueCommand.EXPORT ? 1e-2 : options.contains("table") ? 1e-3 : 1e-6;
        double largest = known.stream()
                .flatMapToDouble(one -> Arrays.stream(one.values()))
                .max()
                .orElseThrow();
        assertThat(largest).as(options).isPositive();
        for (int i = 0; i < known.size(); i++) {
            double[] expected = command.quantity(listed, i);
            for (int c = 0; c < expected.length; c++) {
                assertThat(known.get(i).values()[c])
                        .as(
                                "%s %s at %s",
                                command, options, Arrays.toString(known.get(i).row()))
                        .isCloseTo(expected[c], within(relative * expected[c] + 1e-6 * largest));
            }
        }
    }

    /** Returns the options that both sets hold, with their values. */
    private static String kept(String options, Set<String> one, Set<String> other) {
        String[] words = options.split(" ", -1);
        return IntStream.range(0, words.length / 2)
                .filter(i -> one.contains(words[2 * i]) && other.contains(words[2 * i]))
                .mapToObj(i -> words[2 * i] + " " + words[2 * i + 1])
                .collect(Collectors.joining(" "));
    }

    private static Set<String> accepted(String command) throws IOException {
        Set<String> names =
                options(workplace.succeedHere(command + " --help-all").stdout());
        if (command.equals("evaluate") || command.equals("orders")) {
            // Another option of that name.
            names.remove("--wavelengths");
        }
        return names;
    }

    private static Set<String> options(String text) {
        return OPTION.matcher(text).results().map(MatchResult::group).collect(Collectors.toSet());
    }
}
