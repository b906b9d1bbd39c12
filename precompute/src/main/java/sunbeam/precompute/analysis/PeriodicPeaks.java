package sunbeam.precompute.analysis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Frequencies of a surface that repeats a small patch: bins that hold most of its variance. */
final class PeriodicPeaks {
    /** The share of the variance that makes a grating. A sawtooth's first order has 0.61, a rectangle's 0.81. */
    static final double THRESHOLD = 0.4;

    private final HeightSpectrum spectrum;
    private final double total;

    PeriodicPeaks(HeightSpectrum spectrum) {
        this.spectrum = spectrum;
        this.total = spectrum.total();
    }

    Periodicity all() {
        return among(0, Double.POSITIVE_INFINITY);
    }

    /** Frequencies that lie no farther than a tolerance (cycles per metre) from the line along an azimuth. */
    Periodicity along(double azimuth, double tolerance) {
        return among(azimuth, tolerance);
    }

    private Periodicity among(double azimuth, double tolerance) {
        List<SpectrumPeak> found = new ArrayList<>();
        double figure = 0;
        for (int jy = 0; jy <= spectrum.bandY().last(); jy++) {
            for (int jx = jy == 0 ? 1 : spectrum.bandX().first();
                    jx <= spectrum.bandX().last();
                    jx++) {
                double frequencyX = jx / spectrum.width();
                double frequencyY = jy / spectrum.height();
                double across = frequencyY * Math.cos(azimuth) - frequencyX * Math.sin(azimuth);
                // A bin and its mirror image make one real wave.
                double variance = 2 * spectrum.at(jx, jy);
                double share = total > 0 ? variance / total : 0;
                if (Math.abs(across) <= tolerance) {
                    figure = Math.max(figure, share);
                    if (share >= THRESHOLD) {
                        found.add(new SpectrumPeak(frequencyX, frequencyY, share, Math.sqrt(variance)));
                    }
                }
            }
        }
        found.sort(Comparator.comparingDouble(SpectrumPeak::rms).reversed());
        return new Periodicity(HeightSpectrum.Edges.PERIODIC, found, figure, THRESHOLD);
    }
}
