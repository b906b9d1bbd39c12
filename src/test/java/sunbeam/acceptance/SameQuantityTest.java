package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import sunbeam.app.scene.SceneSettings;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.setting.Setting;

/** Every command that knows a quantity of {@code reflectance} has its value, under every setting that both accept. */
class SameQuantityTest extends InOneWorkplace {
    private static final String PATCH = "grating.txt --width 1.2um --height 200nm --height-unit nm --periodic --force ";
    private static final String WINDOW = "--coherence-length 5um ";
    private static final double SIGMA = 5e-6 / 4;
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
            WINDOW + "--method nmm --average ensemble --fresnel squared --tolerance 1e-3",
            WINDOW + "--method table --average ensemble --index 2 --tolerance 1e-3",
            WINDOW + "--method gem --spacing 1.2um --orders 3 --gem-form stam --fresnel squared --index 2",
            "--method pq --replicas 5 --interpolation sinc --fresnel squared --index 2",
            "--method reference --replicas 5",
            WINDOW + "--method reference --average coherent --window-origin corner",
            WINDOW + "--method reference --average ensemble --preset thesis");

    /** Settings of another quantity: no list of directions has a lamp's width (LampCertificateTest). */
    private static final Set<Setting<?>> NONE = Set.of(SceneSettings.ANGULAR_DIAMETER);

    /** Values at a row of {@code reflectance}: theta_i, phi_i, theta_r, phi_r in degrees and, unless of a color, the wavelength in nm. */
    private record Known(double[] row, double... values) {}

    private enum Command {
        EVALUATE("") {
            @Override
            double[] quantity(CsvFile rows, int i) {
                return new double[] {rows.at(i, "rho")};
            }

            @Override
            List<Known> read() throws IOException {
                CsvFile file = CsvFile.read(workplace.resolve("known.csv"));
                List<Known> all = new ArrayList<>();
                for (double[] line : file.rows()) {
                    for (int i = 1; i < line.length; i++) {
                        double angle = Double.parseDouble(file.header().get(i));
                        double[] row = {40, 0, Math.abs(angle), angle < 0 ? 180 : 0, line[0]};
                        all.add(new Known(row, line[i]));
                    }
                }
                return all;
            }

            @Override
            String words() {
                return "--theta-i 40 --azimuth 0 --angles=-12:12:0.25 --wavelengths 450:650:100 --peaks maximum --output known";
            }
        },
        ORDERS(WINDOW + "--average ensemble --tolerance 1e-3") {
            @Override
            double[] quantity(CsvFile rows, int i) {
                double area = 4 * Math.PI * Math.pow(SIGMA / (1e-9 * rows.at(i, "wavelength")), 2);
                return new double[] {rows.at(i, "brdf") / area};
            }

            @Override
            List<Known> read() throws IOException {
                CsvFile file = CsvFile.read(workplace.resolve("known.csv"));
                return IntStream.range(0, file.size())
                        .mapToObj(i -> new Known(Arrays.copyOf(file.rows().get(i), 5), file.at(i, "efficiency")))
                        .toList();
            }

            @Override
            String words() {
                return "--theta-i 40 --phi-i 10 --wavelengths 450:650:100 --output known";
            }
        },
        BRDF_MAP("") {
            @Override
            double[] quantity(CsvFile rows, int i) {
                return color(rows, i);
            }

            @Override
            List<Known> read() throws IOException {
                int side = 8;
                NpyImage map = NpyImage.read(workplace.resolve("known.npy"), side);
                return IntStream.range(0, side * side)
                        .filter(i -> map.inDisc(i / side, i % side))
                        .mapToObj(i -> new Known(
                                row(40, 10, map.place(i % side), -map.place(i / side)), map.xyz(i / side, i % side)))
                        .toList();
            }

            @Override
            String words() {
                return "--size 8 --theta-i 40 --phi-i 10 --no-annotate --output known.png --linear known.npy";
            }
        },
        COLOR("") {
            @Override
            double[] quantity(CsvFile rows, int i) {
                return color(rows, i);
            }

            @Override
            List<Known> read() throws IOException {
                List<Known> all = new ArrayList<>();
                for (JsonNode one : workplace.readJson("known.json").at("/surfaces/0/colors")) {
                    double angle = one.get("theta_r_deg").asDouble();
                    double phi = one.get("phi_deg").asDouble() + (angle < 0 ? 180 : 0);
                    double[] row = {40, 10, Math.abs(angle), phi};
                    all.add(new Known(
                            row,
                            one.get("X").asDouble(),
                            one.get("Y").asDouble(),
                            one.get("Z").asDouble()));
                }
                return all;
            }

            @Override
            String words() {
                // A step of 0.2 degrees is one direction, also under the window of pq.
                return "--theta-i 40 --phi-i 10 --angles=-42:-37:0.2 --output known.png";
            }
        },
        SAMPLE("--average ensemble") {
            @Override
            double[] quantity(CsvFile rows, int i) {
                // Directions are float32, and orders sharp.
                return new double[] {rows.at(i, "brdf") / rows.at(i, "power")};
            }

            @Override
            List<Known> read() throws IOException {
                try (ZipFile zip = new ZipFile(workplace.resolve("known.npz").toFile())) {
                    float[] light = floats(zip, "light");
                    float[] view = floats(zip, "view");
                    float[] wavelength = floats(zip, "wavelength");
                    float[] power = floats(zip, "power");
                    float[] brdf = floats(zip, "brdf");
                    return IntStream.range(0, power.length)
                            .filter(i -> power[i] > 1e-12)
                            .mapToObj(i -> {
                                double[] wi = row(
                                        Math.toDegrees(Math.acos(light[3 * i + 2])),
                                        Math.toDegrees(Math.atan2(light[3 * i + 1], light[3 * i])),
                                        view[3 * i],
                                        view[3 * i + 1]);
                                double[] row = Arrays.copyOf(wi, 5);
                                row[4] = wavelength[i];
                                return new Known(row, (double) brdf[i] / power[i]);
                            })
                            .toList();
                }
            }

            @Override
            String words() {
                return "--count 12 --channels spectral --output known.npz";
            }
        },
        EXPORT("--average ensemble") {
            @Override
            double[] quantity(CsvFile rows, int i) {
                return new double[] {rows.at(i, "X"), rows.at(i, "Y"), rows.at(i, "Z")};
            }

            /** Returns the brightest texels that directions reach, each by light and view around the half vector -(u, v, w) / 2. */
            @Override
            List<Known> read() throws IOException {
                try (ZipFile zip = new ZipFile(workplace.resolve("known.npz").toFile())) {
                    float[] u = floats(zip, "u");
                    float[] v = floats(zip, "v");
                    float[] w = floats(zip, "w");
                    float[] colors = floats(zip, "C");
                    List<Known> all = new ArrayList<>();
                    for (int i = 0; i < colors.length / 3; i++) {
                        double x = -u[i % u.length] / 2;
                        double y = -v[i / u.length % v.length] / 2;
                        double z = -w[i / u.length / v.length] / 2;
                        double square = x * x + y * y + z * z;
                        double across = Math.sqrt((1 - square) / (x * x + z * z));
                        if (square < 0.9 && z - across * Math.abs(x) > 0.1) {
                            double phi = Math.toDegrees(Math.atan2(y, x + across * z));
                            double[] half = row(theta(x + across * z, y), phi, x - across * z, y);
                            all.add(new Known(half, colors[3 * i], colors[3 * i + 1], colors[3 * i + 2]));
                        }
                    }
                    all.sort(Comparator.comparingDouble(known -> -known.values[1]));
                    return all.subList(0, 20);
                }
            }

            @Override
            String words() {
                return "--format npz --samples 0 --output known.npz";
            }
        };

        private final String always;

        /** @param always options of {@code reflectance} alone */
        Command(String always) {
            this.always = always;
        }

        /** Returns the command's quantity from a row of {@code reflectance}. */
        abstract double[] quantity(CsvFile rows, int i);

        abstract List<Known> read() throws IOException;

        /** Of a sample and an export, which take seconds, reflectance has only window and tolerance. */
        List<String> cases() {
            return switch (this) {
                case SAMPLE -> CASES.subList(0, 1);
                case EXPORT -> List.of(WINDOW + "--tolerance 1e-2");
                default -> CASES;
            };
        }

        abstract String words();

        String label() {
            return name().toLowerCase(Locale.ROOT).replace('_', '-');
        }

        private static double[] color(CsvFile rows, int i) {
            double gain = rows.at(i, "gain");
            return new double[] {gain * rows.at(i, "X"), gain * rows.at(i, "Y"), gain * rows.at(i, "Z")};
        }

        private static double[] row(double theta, double phi, double x, double y) {
            return new double[] {theta, phi, theta(x, y), Math.toDegrees(Math.atan2(y, x))};
        }

        private static double theta(double x, double y) {
            return Math.toDegrees(Math.asin(Math.hypot(x, y)));
        }

        private static float[] floats(ZipFile zip, String name) throws IOException {
            return NpyImage.of(zip.getInputStream(zip.getEntry(name + ".npy")).readAllBytes(), 1)
                    .values();
        }
    }

    @BeforeAll
    static void writeGrating() throws IOException {
        String row = IntStream.range(0, 48)
                .mapToObj(i -> String.format(
                        Locale.ROOT,
                        "%.3f",
                        60 * Math.sin(2 * Math.PI * i / 48) + 25 * Math.sin(4 * Math.PI * i / 48 + 1)))
                .collect(Collectors.joining(" "));
        Files.write(workplace.resolve("grating.txt"), Collections.nCopies(8, row));
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

    @ParameterizedTest
    @EnumSource
    void commandsAgree(Command command) throws IOException {
        Set<String> accepted = accepted(command.label());
        Set<String> ofList = accepted("reflectance");
        Set<String> compared = new HashSet<>();
        for (String options : command.cases()) {
            String both = kept(options, accepted, ofList);
            if (compared.contains(both)) {
                continue;
            }
            SubjectResult result = subject(command, both);
            if (result.isRefused) {
                continue;
            }
            List<double[]> rows = result.known.stream().map(Known::row).toList();
            String own = (command.always + " " + both).strip();
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

    private record SubjectResult(boolean isRefused, List<Known> known) {}

    /** A combination that the command refuses by name is no case. */
    private static SubjectResult subject(Command command, String options) throws IOException {
        SunbeamResult result =
                workplace.here((command.label() + " " + PATCH + options).strip() + " " + command.words());
        if (result.exitCode() == 2) {
            return new SubjectResult(true, List.of());
        }
        // Code 3 says that no view has a color.
        assertThat(result.exitCode()).as("%s", result).isIn(0, 3);
        return new SubjectResult(false, command.read());
    }

    private static void compare(Command command, String options, List<Known> known, CsvFile listed) {
        // One function computes both, in float32, whose sums err relative to the brightest. Colors of a table have its
        // tolerance.
        double relative = command == Command.EXPORT ? 1e-2 : options.contains("table") ? 1e-3 : 1e-6;
        double largest = known.stream()
                .flatMapToDouble(one -> Arrays.stream(one.values))
                .max()
                .orElseThrow();
        assertThat(largest).as(options).isPositive();
        for (int i = 0; i < known.size(); i++) {
            double[] expected = command.quantity(listed, i);
            for (int c = 0; c < expected.length; c++) {
                assertThat(known.get(i).values[c])
                        .as("%s %s at %s", command, options, Arrays.toString(known.get(i).row))
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
