package sunbeam.acceptance;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import java.util.zip.ZipFile;

/** Commands that write a quantity of {@code reflectance}, to files "known.*" of a workplace. */
enum ValueCommand {
    EVALUATE("") {
        @Override
        double[] quantity(CsvFile rows, int i) {
            return new double[] {rows.at(i, "rho")};
        }

        @Override
        List<Known> read(Workplace workplace) throws IOException {
            CsvFile file = CsvFile.read(workplace.resolve("known.csv"));
            List<Known> all = new ArrayList<>();
            for (double[] line : file.rows()) {
                for (int i = 1; i < line.length; i++) {
                    double angle = Double.parseDouble(file.header().get(i));
                    double[] row = {62, 0, Math.abs(angle), angle < 0 ? 180 : 0, line[0]};
                    all.add(new Known(row, line[i]));
                }
            }
            return all;
        }

        @Override
        String words() {
            return "--theta-i 62 --azimuth 0 --angles=-12:12:0.25 --wavelengths 450:650:100 --peaks maximum --output known";
        }
    },
    ORDERS(SameQuantityTest.WINDOW + "--average ensemble --tolerance 1e-3") {
        @Override
        double[] quantity(CsvFile rows, int i) {
            double area = 4 * Math.PI * Math.pow(SIGMA / (1e-9 * rows.at(i, "wavelength")), 2);
            return new double[] {rows.at(i, "brdf") / area};
        }

        @Override
        List<Known> read(Workplace workplace) throws IOException {
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
        List<Known> read(Workplace workplace) throws IOException {
            int side = 8;
            NpyImage map = NpyImage.read(workplace.resolve("known.npy"), side);
            return IntStream.range(0, side * side)
                    .filter(i -> map.inDisc(i / side, i % side))
                    .mapToObj(i -> new Known(
                            row(62, 10, map.place(i % side), -map.place(i / side)), map.xyz(i / side, i % side)))
                    .toList();
        }

        @Override
        String words() {
            return "--size 8 --theta-i 62 --phi-i 10 --no-annotate --output known.png --linear known.npy";
        }
    },
    COLOR("") {
        @Override
        List<Known> read(Workplace workplace) throws IOException {
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
            // The mean over a step errs by its square over 24 deviations of an order, which has 2 degrees or more:
            // 1e-7.
            return "--theta-i 40 --phi-i 10 --angles=-40.6:-40:0.002 --output known.png";
        }
    },
    SAMPLE("--average ensemble") {
        @Override
        double[] quantity(CsvFile rows, int i) {
            // Directions are float32, and orders sharp.
            return new double[] {rows.at(i, "brdf") / rows.at(i, "power")};
        }

        @Override
        List<Known> read(Workplace workplace) throws IOException {
            List<float[]> arrays = arrays(workplace, "light", "view", "wavelength", "power", "brdf");
            float[] light = arrays.get(0);
            float[] view = arrays.get(1);
            float[] wavelength = arrays.get(2);
            float[] power = arrays.get(3);
            float[] brdf = arrays.get(4);
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

        @Override
        String words() {
            return "--count 12 --channels spectral --output known.npz";
        }
    },
    EXPORT("--average ensemble") {
        @Override
        double[] quantity(CsvFile rows, int i) {
            return xyz(rows, i);
        }

        /** Returns the brightest texels that directions reach, each by light and view around the half vector -(u, v, w) / 2. */
        @Override
        List<Known> read(Workplace workplace) throws IOException {
            List<float[]> arrays = arrays(workplace, "u", "v", "w", "C");
            float[] u = arrays.get(0);
            float[] v = arrays.get(1);
            float[] w = arrays.get(2);
            float[] colors = arrays.get(3);
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
            all.sort(Comparator.comparingDouble(known -> -known.values()[1]));
            return all.subList(0, 20);
        }

        @Override
        String words() {
            return "--format npz --samples 0 --output known.npz";
        }
    };

    private static final double SIGMA = 5e-6 / 4; // a quarter of SameQuantityTest.WINDOW

    private final String always;

    /** Values at a row of {@code reflectance}: theta_i, phi_i, theta_r, phi_r in degrees and, unless of a color, the wavelength in nm. */
    record Known(double[] row, double... values) {}

    /** @param always options of {@code reflectance} alone */
    ValueCommand(String always) {
        this.always = always;
    }

    /** Returns the command's quantity from a row of {@code reflectance}. */
    double[] quantity(CsvFile rows, int i) {
        double gain = rows.at(i, "gain");
        return Arrays.stream(xyz(rows, i)).map(value -> gain * value).toArray();
    }

    abstract List<Known> read(Workplace workplace) throws IOException;

    /** Returns options of {@code reflectance} alone. */
    String ofList() {
        return always;
    }

    abstract String words();

    String label() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    static double[] xyz(CsvFile rows, int i) {
        return new double[] {rows.at(i, "X"), rows.at(i, "Y"), rows.at(i, "Z")};
    }

    private static double[] row(double theta, double phi, double x, double y) {
        return new double[] {theta, phi, theta(x, y), Math.toDegrees(Math.atan2(y, x))};
    }

    private static double theta(double x, double y) {
        return Math.toDegrees(Math.asin(Math.hypot(x, y)));
    }

    static List<float[]> arrays(Workplace workplace, String... names) throws IOException {
        List<float[]> arrays = new ArrayList<>();
        try (ZipFile zip = new ZipFile(workplace.resolve("known.npz").toFile())) {
            for (String name : names) {
                byte[] file = zip.getInputStream(zip.getEntry(name + ".npy")).readAllBytes();
                arrays.add(NpyImage.of(file, 1).values());
            }
        }
        return arrays;
    }
}
