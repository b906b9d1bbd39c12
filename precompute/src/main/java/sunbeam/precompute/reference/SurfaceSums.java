package sunbeam.precompute.reference;

import java.util.Arrays;
import sunbeam.precompute.optics.CoherenceWindow;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.WindowOrigin;

/** Sums p = exp(i k w h), or another function of the height, over the rows of a patch: one sum per column and per set of row weights. */
record SurfaceSums(HeightMap heights, boolean isTabulated) {
    /** Decides once whether to tabulate p: that takes as long as a sum over a small map. */
    static SurfaceSums of(HeightMap map) {
        return new SurfaceSums(map, !map.hasTooManyLevels());
    }

    Sums overRows(double w, double wavelength, AxisWeights... alongY) {
        return isTabulated ? overRows(phases(w, wavelength), alongY) : overSamples(w, wavelength, alongY);
    }

    /** Sums without a table of p by height; reads memory sequentially. */
    Sums overSamples(double w, double wavelength, AxisWeights... alongY) {
        double phasePerMeter = 2 * Math.PI / wavelength * w;
        double zero = phaseZero();
        HeightMap map = heights;
        return overRows(
                (row, real, imaginary) -> {
                    for (int column = 0; column < imaginary.length; column++) {
                        imaginary[column] = phasePerMeter * (map.at(column, row) - zero);
                    }
                    // Replaces the phases by their sines.
                    UnitCircle.points(imaginary, real);
                },
                alongY);
    }

    /** Heights with an offset of millimeters would lose digits of the phase; meters. */
    private double phaseZero() {
        return 0.5 * (heights.minimum() + heights.maximum());
    }

    /** Sums any complex function of the height, given at each of {@link #heights()}'s levels. */
    Sums overRows(double[][] values, AxisWeights... alongY) {
        int[] index = heights.index();
        return overRows(
                (row, real, imaginary) -> {
                    for (int column = 0, i = row * real.length; column < real.length; column++, i++) {
                        real[column] = values[0][index[i]];
                        imaginary[column] = values[1][index[i]];
                    }
                },
                alongY);
    }

    private interface RowValues {
        void fill(int row, double[] real, double[] imaginary);
    }

    private Sums overRows(RowValues values, AxisWeights... alongY) {
        HeightMap map = heights;
        Sums sums = new Sums(new double[alongY.length][map.columns()], new double[alongY.length][map.columns()]);
        double[] real = new double[map.columns()];
        double[] imaginary = new double[map.columns()];
        for (int row = 0; row < map.rows(); row++) {
            int at = row;
            if (Arrays.stream(alongY).anyMatch(weights -> weights.real()[at] != 0 || weights.imaginary()[at] != 0)) {
                values.fill(row, real, imaginary);
                for (int b = 0; b < alongY.length; b++) {
                    sums.add(b, real, imaginary, alongY[b], row);
                }
            }
        }
        return sums;
    }

    /** Returns exp(i k w h) of every distinct height: cosines, sines. */
    double[][] phases(double w, double wavelength) {
        double waveNumber = 2 * Math.PI / wavelength;
        double zero = phaseZero();
        double[] levels = heights.levels();
        double[] cosines = new double[levels.length];
        double[] sines = new double[levels.length];
        for (int i = 0; i < levels.length; i++) {
            sines[i] = waveNumber * w * (levels[i] - zero);
        }
        UnitCircle.points(sines, cosines);
        return new double[][] {cosines, sines};
    }

    /** Complex sums over rows, {@code [weighting][column]}. */
    record Sums(double[][] real, double[][] imaginary) {
        private void add(int weighting, double[] re, double[] im, AxisWeights weights, int row) {
            double weightReal = weights.real[row];
            double weightImaginary = weights.imaginary[row];
            double[] sumReal = real[weighting];
            double[] sumImaginary = imaginary[weighting];
            for (int i = 0; i < sumReal.length; i++) {
                sumReal[i] += re[i] * weightReal - im[i] * weightImaginary;
                sumImaginary[i] += re[i] * weightImaginary + im[i] * weightReal;
            }
        }

        double power(int weighting, AxisWeights alongX) {
            double sumReal = 0;
            double sumImaginary = 0;
            for (int i = 0; i < real[weighting].length; i++) {
                double a = real[weighting][i];
                double b = imaginary[weighting][i];
                sumReal += a * alongX.real()[i] - b * alongX.imaginary()[i];
                sumImaginary += a * alongX.imaginary()[i] + b * alongX.real()[i];
            }
            return sumReal * sumReal + sumImaginary * sumImaginary;
        }
    }

    /** Complex weights of the samples along one axis. N is the number of samples and f a frequency in cycles per meter. */
    record AxisWeights(double[] real, double[] imaginary) {
        /**
         * Sample positions along one axis, relative to the sample under the window's maximum.
         *
         * @param step signed distance of neighbors, meters; negative along y, since rows run downwards
         * @param origin index of the sample at position 0
         */
        record Axis(int count, double step, int origin) {
            static Axis x(HeightMap map, WindowOrigin origin) {
                return new Axis(map.columns(), map.pitchX(), origin.sample(map.columns()));
            }

            static Axis y(HeightMap map, WindowOrigin origin) {
                return new Axis(map.rows(), -map.pitchY(), origin.sample(map.rows()));
            }

            double period() {
                return count * Math.abs(step);
            }

            /** Returns the window's amplitudes at each distance, in samples, from its maximum, up to {@code reach} sigma; their sum is 1. */
            double[] window(double sigma, double reach) {
                int extent = (int) Math.floor(reach * sigma / Math.abs(step));
                double[] amplitudes = new double[extent + 1];
                double total = 0;
                for (int i = extent; i >= 0; i--) {
                    amplitudes[i] = CoherenceWindow.amplitude(i * step / sigma);
                    total += i == 0 ? amplitudes[i] : 2 * amplitudes[i];
                }
                for (int i = 0; i <= extent; i++) {
                    amplitudes[i] /= total;
                }
                return amplitudes;
            }
        }

        private AxisWeights(Axis axis) {
            this(new double[axis.count], new double[axis.count]);
        }

        /** Returns exp(+2 pi i f_j x) / N, where f_j is the frequency of a DFT bin. */
        static AxisWeights ofBin(int bin, Axis axis) {
            AxisWeights weights = new AxisWeights(axis);
            int direction = axis.step < 0 ? -1 : 1;
            for (int i = 0; i < axis.count; i++) {
                long steps = Math.floorMod((long) bin * (i - axis.origin) * direction, (long) axis.count);
                weights.add(i, 1.0 / axis.count, angle((double) steps / axis.count));
            }
            return weights;
        }

        /**
         * Returns g(x) exp(+2 pi i f x) / sum g, for the amplitudes g of {@link Axis#window}, summed over all replicas of the patch. A phase
         * factor is that of the sample times that of the replica: one sine for each, not for each pair.
         */
        static AxisWeights ofWindow(double frequency, Axis axis, double[] window) {
            AxisWeights weights = new AxisWeights(axis);
            long extent = window.length - 1L;
            long firstReplica = Math.floorDiv(axis.origin - extent, (long) axis.count);
            long lastReplica = Math.floorDiv(axis.origin + extent, (long) axis.count);
            for (long replica = firstReplica; replica <= lastReplica; replica++) {
                long shift = replica * axis.count - axis.origin;
                int first = (int) Math.max(0, -extent - shift);
                int last = (int) Math.min(axis.count - 1, extent - shift);
                double angle = angle(frequency * axis.step * axis.count * replica);
                double cosine = Math.cos(angle);
                double sine = Math.sin(angle);
                for (int i = first; i <= last; i++) {
                    double gauss = window[(int) Math.abs(shift + i)];
                    weights.real[i] += gauss * cosine;
                    weights.imaginary[i] += gauss * sine;
                }
            }
            for (int i = 0; i < axis.count; i++) {
                double angle = angle(frequency * axis.step * (i - axis.origin));
                double cosine = Math.cos(angle);
                double sine = Math.sin(angle);
                double a = weights.real[i];
                double b = weights.imaginary[i];
                weights.real[i] = a * cosine - b * sine;
                weights.imaginary[i] = a * sine + b * cosine;
            }
            return weights;
        }

        /** Returns exp(+2 pi i f x) / (N Q), summed over Q adjacent replicas of the patch. */
        static AxisWeights ofReplicas(double frequency, Axis axis, int replicas) {
            AxisWeights weights = new AxisWeights(axis);
            double amount = 1.0 / axis.count / replicas;
            for (int replica = 0; replica < replicas; replica++) {
                for (int i = 0; i < axis.count; i++) {
                    double position = ((double) replica * axis.count + i) * axis.step;
                    weights.add(i, amount, angle(frequency * position));
                }
            }
            return weights;
        }

        private void add(int index, double amount, double angle) {
            real[index] += amount * Math.cos(angle);
            imaginary[index] += amount * Math.sin(angle);
        }

        /** Whole turns are removed first, since they cost digits. */
        private static double angle(double turns) {
            return 2 * Math.PI * (turns - Math.rint(turns));
        }
    }

    /**
     * Computes cosines and sines, five times as fast as the Java library, by a table at 4096 angles and Taylor series for the remainder, whose
     * truncation errs by 2e-18. Rounding errs by 2e-16 times the larger of the angle and one.
     */
    static final class UnitCircle {
        private static final int STEPS = 1 << 12;
        private static final double STEP = 2 * Math.PI / STEPS;
        private static final double STEPS_PER_RADIAN = STEPS / (2 * Math.PI);
        private static final double[] COSINES = new double[STEPS];
        private static final double[] SINES = new double[STEPS];

        static {
            for (int i = 0; i < STEPS; i++) {
                COSINES[i] = Math.cos(i * STEP);
                SINES[i] = Math.sin(i * STEP);
            }
        }

        /** Replaces angles, radians of magnitude up to 1e6, by their sines, and computes their cosines. */
        static void points(double[] angles, double[] cosines) {
            for (int i = 0; i < angles.length; i++) {
                double steps = angles[i] * STEPS_PER_RADIAN;
                double nearest = Math.rint(steps);
                int place = (int) nearest & STEPS - 1;
                double rest = (steps - nearest) * STEP;
                double square = rest * rest;
                double sine = rest * (1 - square * (1.0 / 6));
                double cosine = 1 - 0.5 * square * (1 - square * (1.0 / 12));
                cosines[i] = COSINES[place] * cosine - SINES[place] * sine;
                angles[i] = SINES[place] * cosine + COSINES[place] * sine;
            }
        }
    }
}
