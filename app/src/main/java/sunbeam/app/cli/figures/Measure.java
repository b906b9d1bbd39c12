package sunbeam.app.cli.figures;

import com.fasterxml.jackson.annotation.JsonValue;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import sunbeam.app.files.input.ImageFile;
import sunbeam.app.files.input.PngText;
import sunbeam.app.picture.PictureDifference;
import sunbeam.precompute.color.CieLab;
import sunbeam.precompute.color.Srgb;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.numerics.Quantiles;

/** Quantity that a {@link Check} measures in a picture, or in the file of numbers beside it. */
enum Measure {
    CHROMA("mean chroma"),
    CHROMA_IN_THE_MIDDLE("chroma in the middle"),
    CHROMA_ON_THE_RIGHT("mean chroma on the right"),
    CHROMA_OF_THE_LIGHT("chroma of the light"),
    VARIETY_OF_HUES("variety of hues"),
    LIGHT_ON_THE_LEFT("share of light on the left"),
    LIGHT_ALONG_X("share of light along x"),
    BRIGHT_SHARE("share of bright pixels"),
    SPECTRUM("b* of the first order, 550 to 700 nm less 400 to 500 nm"),
    MEDIAN_DIFFERENCE("median CIEDE2000"),
    DIFFERENCE("95th percentile of CIEDE2000"),
    CHANGE_OF_COLORS("95th percentile of the distance in a* and b*"),
    WIDTH("width of the maximum in degrees"),
    CONTRAST("first order over the light half-way to it"),
    NUMBER("number"),
    DEVIATION("relative deviation from the thesis"),
    DEVIATION_IN_SPREADS("deviation of the mean in standard deviations of the thesis"),
    RATIO_OF_VARIANCES("ratio of variances");

    private static final Region EVERYWHERE = (x, y) -> true;
    /** Radius of the mirror direction's neighborhood in a map whose radius is 1. */
    private static final double NEAR = 0.03;
    /** Least sine of a visible first order: 380 nm over 2.5 um, the widest of the three periods. */
    private static final double FIRST_ORDER = 0.152;
    /** Period of the gratings in figures 4.5 and 4.6, nanometers. */
    private static final double PERIOD = 2500;
    /** Linear luminance of a bright pixel relative to the display's white. */
    private static final double BRIGHT = 0.1;
    /** Wavelength of the response of figure 4.5, nanometers. */
    private static final double WAVELENGTH = 500;

    private static final String MEAN = "mean_nm";
    private static final String VARIANCE = "variance_nm2";

    private final String label;

    Measure(String label) {
        this.label = label;
    }

    @Override
    @JsonValue
    public String toString() {
        return label;
    }

    /** Response over the angle in degrees at one wavelength, as evaluate writes it, the largest value being 1. */
    record Response(double[] angles, double[] values) {
        static Response read(Figure.Drawing drawing) {
            Path file = drawing.beside(".csv");
            try {
                List<String> lines = Files.readAllLines(file);
                double[] values = numbers(lines.get(1));
                double largest = Arrays.stream(values).max().orElseThrow();
                return new Response(
                        numbers(lines.get(0)),
                        Arrays.stream(values).map(value -> value / largest).toArray());
            } catch (IOException failure) {
                throw InputException.of(file, failure);
            }
        }

        private static double[] numbers(String line) {
            return Stream.of(line.split(",", -1))
                    .skip(1)
                    .mapToDouble(Double::parseDouble)
                    .toArray();
        }

        /** Returns the light in the direction of the first order over that in the direction of half its sine. */
        double contrast() {
            return at(WAVELENGTH / PERIOD) / at(WAVELENGTH / PERIOD / 2);
        }

        private double at(double sine) {
            double angle = Math.toDegrees(Math.asin(sine));
            return values[
                    IntStream.range(0, angles.length)
                            .boxed()
                            .min(Comparator.comparingDouble(i -> Math.abs(angles[i] - angle)))
                            .orElseThrow()];
        }

        double width() {
            int top = Arrays.stream(values).boxed().toList().indexOf(1.0);
            int left = top;
            while (left > 0 && values[left] >= 0.5) {
                left--;
            }
            int right = top;
            while (right < values.length - 1 && values[right] >= 0.5) {
                right++;
            }
            return angles[right] - angles[left];
        }
    }

    /** Region of a map: x to the right, y up, from -1 to 1. */
    private interface Region {
        boolean contains(double x, double y);
    }

    /** Measures a picture, or a number at a JSON pointer, perhaps beside another picture; NaN if the command did not write it. */
    double of(Figure.Drawing drawing, String pointer, Figure.Drawing base) {
        return switch (this) {
            case CHROMA -> chroma(drawing, EVERYWHERE);
            case CHROMA_IN_THE_MIDDLE -> chroma(drawing, (x, y) -> Math.hypot(x, y) < NEAR);
            case CHROMA_ON_THE_RIGHT ->
                colors(drawing, (x, y) -> x > NEAR && Math.hypot(x, y) < 1)
                        .mapToDouble(Measure::chroma)
                        .average()
                        .orElse(0);
            case CHROMA_OF_THE_LIGHT ->
                sum(drawing, EVERYWHERE, rgb -> luminance(rgb) * chroma(rgb)) / light(drawing, EVERYWHERE);
            case VARIETY_OF_HUES -> varietyOfHues(drawing);
            case LIGHT_ON_THE_LEFT ->
                light(drawing, (x, y) -> x < -NEAR) / light(drawing, (x, y) -> Math.abs(x) > NEAR);
            case LIGHT_ALONG_X ->
                light(drawing, (x, y) -> Math.hypot(x, y) > FIRST_ORDER && Math.abs(x) > Math.abs(y))
                        / light(drawing, (x, y) -> Math.hypot(x, y) > FIRST_ORDER);
            case BRIGHT_SHARE ->
                colors(drawing, EVERYWHERE)
                                .filter(rgb -> luminance(rgb) > BRIGHT)
                                .count()
                        / (double) colors(drawing, EVERYWHERE).count();
            case SPECTRUM -> meanB(drawing, 550, 700) - meanB(drawing, 400, 500);
            case MEDIAN_DIFFERENCE -> difference(drawing.file(), base.file()).median();
            case DIFFERENCE -> difference(drawing.file(), base.file()).high();
            case CHANGE_OF_COLORS -> changeOfColors(drawing, base);
            case WIDTH -> has(drawing, ".csv") ? Response.read(drawing).width() : Double.NaN;
            case CONTRAST -> has(drawing, ".csv") ? Response.read(drawing).contrast() : Double.NaN;
            case NUMBER -> number(drawing, pointer);
            case DEVIATION -> Math.abs(ratio(drawing, MEAN) - 1);
            case DEVIATION_IN_SPREADS ->
                Math.abs(number(drawing, thesis(drawing, MEAN).getKey())
                                - thesis(drawing, MEAN).getValue())
                        / Math.sqrt(thesis(drawing, VARIANCE).getValue());
            case RATIO_OF_VARIANCES -> Math.max(ratio(drawing, VARIANCE), 1 / ratio(drawing, VARIANCE));
        };
    }

    /** Returns the thesis's number of a kind, and where ours is. */
    private static Map.Entry<String, Double> thesis(Figure.Drawing drawing, String kind) {
        return drawing.picture().numbers().entrySet().stream()
                .filter(number -> number.getKey().endsWith(kind))
                .findFirst()
                .orElseThrow();
    }

    private static double ratio(Figure.Drawing drawing, String kind) {
        Map.Entry<String, Double> thesis = thesis(drawing, kind);
        return number(drawing, thesis.getKey()) / thesis.getValue();
    }

    private static boolean has(Figure.Drawing drawing, String ending) {
        return Files.isRegularFile(drawing.beside(ending));
    }

    private static BufferedImage image(Path file) {
        return ImageFile.ours(file, "remove it");
    }

    static PictureDifference difference(Path file, Path base) {
        return PictureDifference.of(image(file), image(base));
    }

    /** Returns the mean CIELAB chroma of a region's pixels that do not have the background's color, that of the picture's corner. */
    private static double chroma(Figure.Drawing drawing, Region region) {
        int background = colors(drawing, EVERYWHERE).findFirst().orElseThrow();
        return colors(drawing, region)
                .filter(rgb -> rgb != background)
                .mapToDouble(Measure::chroma)
                .average()
                .orElse(0);
    }

    /** Returns the variety of hues, 1 - |mean of (a, b)| / mean chroma in CIELAB: 0 for a single hue, 1 for evenly spread ones. */
    private static double varietyOfHues(Figure.Drawing drawing) {
        double a = sum(drawing, EVERYWHERE, rgb -> CieLab.ofSrgb(rgb).a());
        double b = sum(drawing, EVERYWHERE, rgb -> CieLab.ofSrgb(rgb).b());
        return 1 - Math.hypot(a, b) / sum(drawing, EVERYWHERE, Measure::chroma);
    }

    private static double changeOfColors(Figure.Drawing drawing, Figure.Drawing base) {
        int[] ours = colors(drawing, EVERYWHERE).toArray();
        int[] others = colors(base, EVERYWHERE).toArray();
        double[] distances = IntStream.range(0, others.length)
                .filter(i -> (ours[i] | others[i]) != 0)
                .mapToDouble(i -> {
                    CieLab color = CieLab.ofSrgb(ours[i]);
                    CieLab other = CieLab.ofSrgb(others[i]);
                    return Math.hypot(color.a() - other.a(), color.b() - other.b());
                })
                .toArray();
        return distances.length == 0 ? 0 : Quantiles.of(distances, 0.95);
    }

    /** Returns the mean b* (CIELAB) where the first orders of a period along x have these wavelengths in nanometers. */
    private static double meanB(Figure.Drawing drawing, double from, double to) {
        Region region = (x, y) -> Math.abs(x) > from / PERIOD && Math.abs(x) < to / PERIOD && Math.abs(y) < NEAR;
        return colors(drawing, region)
                .mapToDouble(rgb -> CieLab.ofSrgb(rgb).b())
                .average()
                .orElse(Double.NaN);
    }

    private static double light(Figure.Drawing drawing, Region region) {
        return sum(drawing, region, Measure::luminance);
    }

    private static double sum(Figure.Drawing drawing, Region region, IntToDoubleFunction quantity) {
        return colors(drawing, region).mapToDouble(quantity).sum();
    }

    private static double chroma(int rgb) {
        return CieLab.ofSrgb(rgb).chroma();
    }

    private static double luminance(int rgb) {
        return 0.2126 * Srgb.linear(rgb >> 16 & 0xff)
                + 0.7152 * Srgb.linear(rgb >> 8 & 0xff)
                + 0.0722 * Srgb.linear(rgb & 0xff);
    }

    /** Returns the colors 0xRRGGBB of a region's pixels, row by row. */
    private static IntStream colors(Figure.Drawing drawing, Region region) {
        BufferedImage image = image(drawing.file());
        int width = image.getWidth();
        int height = image.getHeight();
        return IntStream.range(0, width * height)
                .filter(pixel -> {
                    int row = pixel / width;
                    return region.contains(2 * (pixel % width + 0.5) / width - 1, 1 - 2 * (row + 0.5) / height);
                })
                .map(pixel -> image.getRGB(pixel % width, pixel / width) & 0xffffff);
    }

    /** Returns the sum of the errors of Y over the sum of Y, of two linear maps. */
    static double error(Figure.Drawing drawing, Figure.Drawing base) {
        FloatBuffer ours = linear(drawing);
        FloatBuffer exact = linear(base);
        double wrong = 0;
        double all = 0;
        for (int y = 1; y < exact.limit(); y += 3) {
            if (!Float.isNaN(exact.get(y))) {
                wrong += Math.abs(ours.get(y) - exact.get(y));
                all += exact.get(y);
            }
        }
        return wrong / all;
    }

    private static FloatBuffer linear(Figure.Drawing drawing) {
        Path file = drawing.beside(".npy");
        try {
            ByteBuffer bytes = ByteBuffer.wrap(Files.readAllBytes(file)).order(ByteOrder.LITTLE_ENDIAN);
            return bytes.position(10 + bytes.getShort(8))
                    .slice()
                    .order(ByteOrder.LITTLE_ENDIAN)
                    .asFloatBuffer();
        } catch (IOException failure) {
            throw InputException.of(file, failure);
        }
    }

    /** Reads a number that the command wrote; NaN if there is none. A pointer's _nm and _nm2 stand for numbers in meters (_m, _m2). */
    static double number(Figure.Drawing drawing, String pointer) {
        Path file = drawing.beside(".json");
        try {
            String numbers = Files.exists(file)
                    ? Files.readString(file)
                    : PngText.read(drawing.file()).get("Extremes");
            if (numbers == null) {
                return Double.NaN;
            }
            double unit = pointer.endsWith("_nm2") ? 1e18 : pointer.endsWith("_nm") ? 1e9 : 1;
            JsonNode number = new ObjectMapper().readTree(numbers).at(pointer.replaceFirst("_nm(2?)$", "_m$1"));
            return unit * number.asDouble(Double.NaN);
        } catch (IOException failure) {
            throw InputException.of(file, failure);
        }
    }
}
