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
import java.util.List;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import sunbeam.app.files.input.ImageFile;
import sunbeam.app.files.input.PngText;
import sunbeam.app.gpu.picture.PictureDifference;
import sunbeam.precompute.color.CieLab;
import sunbeam.precompute.color.Srgb;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.text.Text;

/** Quantity that a {@link Check} measures in a picture, or in the file of numbers beside it. */
enum Measure {
    CHROMA("mean chroma"),
    CHROMA_IN_THE_MIDDLE("chroma in the middle"),
    CHROMA_ON_THE_RIGHT("mean chroma on the right"),
    CHROMA_OF_THE_LIGHT("chroma of the light"),
    VARIETY_OF_HUES("variety of hues"),
    LIGHT_ON_THE_LEFT("share of light on the left"),
    LIGHT_ALONG_X("share of light along x"),
    MEDIAN_DIFFERENCE("median CIEDE2000"),
    DIFFERENCE("95th percentile of CIEDE2000"),
    ERROR("error of the light"),
    WIDTH("width of the maximum in degrees"),
    NUMBER("number"),
    DEVIATION("relative deviation from the thesis");

    private static final Region EVERYWHERE = (x, y) -> true;
    /** Radius of the mirror direction's neighborhood in a map whose radius is 1. */
    private static final double NEAR = 0.03;

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
            case CHROMA_ON_THE_RIGHT -> chroma(drawing, (x, y) -> x > NEAR);
            case CHROMA_OF_THE_LIGHT ->
                sum(drawing, EVERYWHERE, rgb -> luminance(rgb) * chroma(rgb)) / light(drawing, EVERYWHERE);
            case VARIETY_OF_HUES -> varietyOfHues(drawing);
            case LIGHT_ON_THE_LEFT ->
                light(drawing, (x, y) -> x < -NEAR) / light(drawing, (x, y) -> Math.abs(x) > NEAR);
            case LIGHT_ALONG_X ->
                light(drawing, (x, y) -> Math.abs(x) > Math.max(NEAR, Math.abs(y)))
                        / light(drawing, (x, y) -> Math.max(Math.abs(x), Math.abs(y)) > NEAR);
            case MEDIAN_DIFFERENCE -> difference(drawing.file(), base.file()).median();
            case DIFFERENCE -> difference(drawing.file(), base.file()).high();
            case ERROR -> has(drawing, ".npy") && has(base, ".npy") ? error(drawing, base) : Double.NaN;
            case WIDTH -> has(drawing, ".csv") ? Response.read(drawing).width() : Double.NaN;
            case NUMBER -> number(drawing, pointer);
            case DEVIATION ->
                drawing.picture().numbers().entrySet().stream()
                        .mapToDouble(entry -> Math.abs(number(drawing, entry.getKey()) / entry.getValue() - 1))
                        .findFirst()
                        .orElseThrow();
        };
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

    /**
     * Measurement of a figure's pictures, and the rule by which the thesis's claim holds.
     *
     * @param of pictures to measure, each as patch, hyphen, name and, for a number, a JSON pointer
     * @param to picture to compare with; null for none
     * @param rule {@code ascending}, {@code descending}, or limits such as {@code < 1}: one for all values or one for each
     */
    record Check(Measure measure, List<String> of, String to, String rule) {
        /** Least ratio of neighbors that ascend or descend: measured at 96 and 256 pixels, a value differs by less. */
        private static final double STEP = 1.05;

        record Verdict(boolean agrees, String numbers) {
            @Override
            public String toString() {
                return (agrees ? "agrees" : "differs") + ": " + numbers;
            }
        }

        Optional<Verdict> verdict(List<Figure.Drawing> drawings) {
            Figure.Drawing base = to == null ? null : find(drawings, to).orElse(null);
            if (to != null && base == null) {
                return Optional.empty();
            }
            double[] values = of.stream()
                    .mapToDouble(name -> find(drawings, name)
                            .map(drawing -> measure.of(drawing, pointer(name), base))
                            .orElse(Double.NaN))
                    .toArray();
            if (Arrays.stream(values).anyMatch(Double::isNaN)) {
                return Optional.empty();
            }
            String numbers = IntStream.range(0, values.length)
                    .mapToObj(i -> of.get(i).replaceFirst("/.*", "") + Text.format(" %.3g", values[i]))
                    .collect(Collectors.joining(", "));
            String from = to == null ? "" : " from " + to;
            return Optional.of(new Verdict(holds(values), measure + from + ": " + numbers + " (" + rule + ")"));
        }

        private static Optional<Figure.Drawing> find(List<Figure.Drawing> drawings, String name) {
            String picture = name.replaceFirst("/.*", "");
            return drawings.stream()
                    .filter(drawing -> drawing.name().equals(picture) && Files.isRegularFile(drawing.file()))
                    .findFirst();
        }

        private static String pointer(String name) {
            return name.contains("/") ? name.substring(name.indexOf('/')) : "";
        }

        private boolean holds(double[] values) {
            String[] limits = rule.split(", ", -1);
            return IntStream.range(0, values.length).allMatch(i -> switch (rule) {
                case "ascending" -> i == 0 || values[i] > STEP * values[i - 1];
                case "descending" -> i == 0 || STEP * values[i] < values[i - 1];
                default -> isWithin(limits[limits.length == 1 ? 0 : i], values[i]);
            });
        }

        private static boolean isWithin(String limit, double value) {
            double number = Double.parseDouble(limit.substring(2));
            return limit.startsWith("<") ? value < number : value > number;
        }
    }
}
