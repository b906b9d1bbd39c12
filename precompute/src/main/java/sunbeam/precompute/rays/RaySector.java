package sunbeam.precompute.rays;

import java.util.Arrays;
import sunbeam.precompute.colortable.ColorColumns;

/** A sector of an octave: colors on its rays, and interpolated between them. */
final class RaySector {
    private static final int COLORS = 3;
    private static final int MARGIN = QuinticSpline.MARGIN;
    // So many share what is blurred along them.
    private static final int FAN_RAYS = 64;

    private final RayOctave octave;
    private final RayConvolution convolution;
    private final WindowedPowers powers;
    private final Runnable between;
    private final int firstRay;
    private final int rays;
    private final int count;

    /**
     * Nothing is made yet.
     *
     * @param convolution of the octave
     * @param between run after each ray
     */
    RaySector(WindowedPowers powers, Places sector, RayConvolution convolution, Runnable between) {
        this.octave = sector.octave();
        this.convolution = convolution;
        this.between = between;
        this.powers = powers;
        this.firstRay = octave.firstRay(sector.sector()) - MARGIN;
        this.rays = octave.firstRay(sector.sector() + 1) + MARGIN + 1 - firstRay;
        this.count = convolution.count();
    }

    /** Numbers of columns that lie in a sector, or in the middle, where rays meet. */
    static final class Places {
        private final RayOctave octave;
        private final int sector;
        private int[] numbers = new int[16];
        private int count;

        /**
         * None yet.
         *
         * @param octave null for the middle
         * @param sector its number in the octave
         */
        Places(RayOctave octave, int sector) {
            this.octave = octave;
            this.sector = sector;
        }

        void add(int number) {
            if (count == numbers.length) {
                numbers = Arrays.copyOf(numbers, 2 * count);
            }
            numbers[count++] = number;
        }

        RayOctave octave() {
            return octave;
        }

        int sector() {
            return sector;
        }

        int count() {
            return count;
        }

        int[] numbers() {
            return Arrays.copyOf(numbers, count);
        }

        boolean isInMiddle() {
            return octave == null;
        }

        /** Three values of each column out of those of all. */
        float[] of(float[] all) {
            float[] some = new float[COLORS * count];
            for (int i = 0; i < count; i++) {
                System.arraycopy(all, COLORS * numbers[i], some, COLORS * i, COLORS);
            }
            return some;
        }

        /** Puts three values of each column where they stand among those of all. */
        void put(float[] some, float[] all) {
            for (int i = 0; i < count; i++) {
                System.arraycopy(some, COLORS * i, all, COLORS * numbers[i], COLORS);
            }
        }
    }

    /**
     * Evaluates columns.
     *
     * @param asked numbers of those that lie in the sector
     * @param prepared index of each slice among those that the convolution is prepared for
     * @return how many places that were
     */
    int evaluate(ColorColumns columns, int[] asked, int[] prepared) {
        boolean[] wanted = new boolean[convolution.slices()];
        int places = 0;
        int[] slices = new int[prepared.length];
        for (int column : asked) {
            int some = columns.asked(column, slices);
            for (int j = 0; j < some; j++) {
                wanted[prepared[slices[j]]] = true;
            }
            places += some;
        }
        float[][] planes = planes(wanted);
        double[] alongRay = new double[QuinticSpline.TAPS];
        double[] acrossRays = new double[QuinticSpline.TAPS];
        float[] uv = new float[2];
        for (int column : asked) {
            columns.locate(column, uv);
            double place = octave.onRay(Math.sqrt((double) uv[0] * uv[0] + (double) uv[1] * uv[1]));
            double ray = octave.ray(uv[0], uv[1]) - firstRay;
            // Both lie behind the margins: whole parts are floors.
            int along = (int) place;
            int across = (int) ray;
            QuinticSpline.weights(place - along, alongRay);
            QuinticSpline.weights(ray - across, acrossRays);
            int corner = (along - 2) * rays + across - 2;
            int some = columns.asked(column, slices);
            for (int j = 0; j < some; j++) {
                int plane = COLORS * prepared[slices[j]];
                columns.putRoots(
                        column,
                        slices[j],
                        interpolated(planes[plane], corner, acrossRays, alongRay),
                        interpolated(planes[plane + 1], corner, acrossRays, alongRay),
                        interpolated(planes[plane + 2], corner, acrossRays, alongRay));
            }
        }
        return places;
    }

    /** Six values a row, written out: some million times an interpolation, Java's first compiler takes loops as they are. */
    private double interpolated(float[] plane, int corner, double[] inRow, double[] acrossRows) {
        double first = inRow[0];
        double second = inRow[1];
        double third = inRow[2];
        double fourth = inRow[3];
        double fifth = inRow[4];
        double sixth = inRow[5];
        double sum = 0;
        int at = corner;
        for (int row = 0; row < QuinticSpline.TAPS; row++) {
            sum += acrossRows[row]
                    * (first * plane[at]
                            + second * plane[at + 1]
                            + third * plane[at + 2]
                            + fourth * plane[at + 3]
                            + fifth * plane[at + 4]
                            + sixth * plane[at + 5]);
            at += rays;
        }
        return sum;
    }

    /** Splines through the square roots of colors, of the slices that are wanted. */
    private float[][] planes(boolean[] wanted) {
        float[][] planes = new float[COLORS * wanted.length][];
        for (int i = 0; i < planes.length; i++) {
            planes[i] = wanted[i / COLORS] ? new float[rays * count] : null;
        }
        RayConvolution.Line line = convolution.line(powers.stride());
        int next;
        for (int i = 0; i < rays; i = next) {
            next = endOfFan(i);
            RayFan fan = powers.fan(angle(i), angle(next - 1), convolution.knots());
            for (int ray = i; ray < next; ray++) {
                line.colors(fan, angle(ray), planes, ray * count);
                between.run();
            }
        }
        for (int i = 0; i < planes.length; i++) {
            planes[i] = planes[i] == null ? null : spline(planes[i]);
        }
        return planes;
    }

    /** The first ray that is closer to another axis than some ray, or one so far from it that what rays share does not fit into a processor's cache. */
    private int endOfFan(int first) {
        boolean alongX = WindowedPowers.isAlongX(angle(first));
        int end = first + 1;
        while (end < Math.min(rays, first + FAN_RAYS)
                && WindowedPowers.isAlongX(angle(end)) == alongX
                && angle(end) - angle(first) < Math.PI / 2) {
            end++;
        }
        return end;
    }

    /** Of a ray from the x axis on; those before it are below nothing. */
    private double angle(int ray) {
        return 2 * Math.PI * (firstRay + ray) / octave.rays();
    }

    /** {@code [place][ray]} */
    private float[] spline(float[] plane) {
        for (int i = 0; i < plane.length; i++) {
            // Sums of terms may leave a dark direction a little below nothing.
            plane[i] = (float) Math.sqrt(Math.max(0, plane[i]));
        }
        return QuinticSpline.coefficients(plane, rays, count);
    }
}
