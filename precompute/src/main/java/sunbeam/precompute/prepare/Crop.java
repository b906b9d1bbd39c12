package sunbeam.precompute.prepare;

import java.util.function.DoubleFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.text.Text;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/** Rectangular part of a scan, in meters from its lower left corner. */
public record Crop(double left, double right, double bottom, double top) {
    /** Text form on the command line and in files, such as {@code 5um:25um,0um:10um}. */
    public static final ValueKind<Crop> KIND = ValueKind.text(
            "AREA",
            Crop::parse,
            crop -> format(Lengths::exact, crop.left, crop.right, crop.bottom, crop.top),
            "LEFT:RIGHT,BOTTOM:TOP, such as 5um:25um,0um:10um");

    private static final Pattern FORM = Pattern.compile("([^:,]+):([^:,]+),([^:,]+):([^:,]+)");
    private static final Pattern HAS_UNIT = Pattern.compile("\\p{L}");
    // In samples; lengths are written with six digits.
    private static final double SLACK = 1e-5;

    public Crop {
        if (!(left >= 0 && bottom >= 0 && right > left && top > bottom)) {
            throw new IllegalArgumentException(format(Lengths::exact, left, right, bottom, top)
                    + " is no area: give LEFT:RIGHT,BOTTOM:TOP from 0 upwards");
        }
    }

    private static Crop parse(String text) {
        Matcher matcher = FORM.matcher(text.strip());
        if (!matcher.matches()) {
            throw new IllegalArgumentException(Text.quoted(text)
                    + " is no area of four lengths; give LEFT:RIGHT,BOTTOM:TOP, such as 5um:25um,0um:10um"
                    + (HAS_UNIT.matcher(text).find() ? Decimals.commaRemedy(text) : ""));
        }
        return new Crop(edge(matcher.group(1)), edge(matcher.group(2)), edge(matcher.group(3)), edge(matcher.group(4)));
    }

    private static double edge(String text) {
        return text.strip().equals("0") ? 0 : Lengths.parse(text.strip());
    }

    private static String format(DoubleFunction<String> length, double left, double right, double bottom, double top) {
        return length.apply(left) + ":" + length.apply(right) + "," + length.apply(bottom) + ":" + length.apply(top);
    }

    /** Rectangle of a scan's samples; row 0 is the top one, ends are exclusive. */
    public record Samples(int firstColumn, int endColumn, int firstRow, int endRow) {
        public static Samples allOf(HeightMap field) {
            return new Samples(0, field.columns(), 0, field.rows());
        }

        private int columns() {
            return Math.max(0, endColumn - firstColumn);
        }

        private int rows() {
            return Math.max(0, endRow - firstRow);
        }

        Samples rows(int from, int to) {
            return new Samples(firstColumn, endColumn, firstRow + from, firstRow + to);
        }

        public Crop area(HeightMap field) {
            return new Crop(
                    firstColumn * field.pitchX(),
                    endColumn * field.pitchX(),
                    (field.rows() - endRow) * field.pitchY(),
                    (field.rows() - firstRow) * field.pitchY());
        }
    }

    /** Returns this area relative to the point (x, y), in meters, without the parts to its left and below it. */
    public Crop from(double x, double y) {
        return new Crop(Math.max(0, left - x), right - x, Math.max(0, bottom - y), top - y);
    }

    /** Returns the text form with six digits, enough to select the same samples. */
    public String written() {
        return format(Crop::written, left, right, bottom, top);
    }

    private static String written(double meters) {
        return meters == 0 ? "0" : Lengths.format(meters).replace(" ", "");
    }

    /** Returns the samples whose centers lie in the area; throws IllegalArgumentException if it leaves the scan or holds fewer than two. */
    public Samples samples(HeightMap field) {
        if (right > field.width() * (1 + SLACK) || top > field.height() * (1 + SLACK)) {
            throw new IllegalArgumentException("leaves the scan, which is " + Lengths.format(field.width()) + " x "
                    + Lengths.format(field.height()) + "; give an area within 0:"
                    + written(field.width()) + ",0:" + written(field.height()));
        }
        // Rows run downwards, y upwards.
        Samples samples = new Samples(
                first(left, field.pitchX()),
                Math.min(field.columns(), first(right, field.pitchX())),
                field.rows() - Math.min(field.rows(), first(top, field.pitchY())),
                field.rows() - first(bottom, field.pitchY()));
        if ((long) samples.columns() * samples.rows() < 2) {
            throw new IllegalArgumentException("holds " + samples.columns() + " x " + samples.rows()
                    + " samples, which lie " + Lengths.format(field.pitchX()) + " x " + Lengths.format(field.pitchY())
                    + " apart; give a larger area");
        }
        return samples;
    }

    public HeightMap apply(HeightMap field) {
        Samples samples = samples(field);
        return field.part(samples.firstColumn, samples.firstRow, samples.columns(), samples.rows());
    }

    /** Returns the index of the first sample whose center lies at or beyond a position, meters. */
    private static int first(double position, double pitch) {
        return (int) Math.ceil(position / pitch - 0.5 - SLACK);
    }
}
