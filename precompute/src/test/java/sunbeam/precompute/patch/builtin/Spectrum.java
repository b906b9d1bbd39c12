package sunbeam.precompute.patch.builtin;

import sunbeam.precompute.analysis.HeightSpectrum;
import sunbeam.precompute.optics.HeightMap;

/** Power spectrum of a patch's heights without their mean, up to the finest that diffract light. */
final class Spectrum {
    private final HeightSpectrum spectrum;

    Spectrum(HeightMap patch) {
        spectrum = HeightSpectrum.of(patch, HeightSpectrum.Edges.PERIODIC);
    }

    /** Selects bins by their signed numbers of periods across the patch, q upwards. */
    interface Bins {
        boolean contains(int p, int q);
    }

    private interface Visitor {
        void visit(int p, int q, double meanSquare);
    }

    private void forEach(Bins bins, Visitor visitor) {
        for (int q = spectrum.bandY().first(); q <= spectrum.bandY().last(); q++) {
            for (int p = spectrum.bandX().first(); p <= spectrum.bandX().last(); p++) {
                if (bins.contains(p, q)) {
                    visitor.visit(p, q, spectrum.at(p, q));
                }
            }
        }
    }

    /** Mean square of the heights in these bins. */
    double meanSquare(Bins bins) {
        double[] sum = new double[1];
        forEach(bins, (p, q, meanSquare) -> sum[0] += meanSquare);
        return sum[0];
    }

    /** Mean squares of these bins by their absolute number of periods along x. */
    double[] byP(Bins bins) {
        double[] sums = new double[spectrum.bandX().last() + 1];
        forEach(bins, (p, q, meanSquare) -> sums[Math.abs(p)] += meanSquare);
        return sums;
    }

    /** Mean squares of these bins by their absolute number of periods along y. */
    double[] byQ(Bins bins) {
        double[] sums = new double[spectrum.bandY().last() + 1];
        forEach(bins, (p, q, meanSquare) -> sums[Math.abs(q)] += meanSquare);
        return sums;
    }
}
