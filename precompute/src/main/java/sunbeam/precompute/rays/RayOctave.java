package sunbeam.precompute.rays;

import java.util.ArrayList;
import java.util.List;
import sunbeam.precompute.color.WavelengthNodes;

/** Rays of an octave of |(u, v)|, and the places on them that belong to each of its sectors. */
final class RayOctave {
    // Rays of a sector; those beside it that splines see come on top.
    private static final int SECTOR_RAYS = 192;
    // Of ln lambda: colour matching functions have weights of their own, and terms' coefficients turn slower.
    private static final double WIDEST_STEP = 0.01;

    private static final double LITTLE_LONGER = 1.12;

    private final RaySpectrum spectrum;
    private final double low;
    private final int rays;
    private final double[] depths;
    private final double widestStep;
    private final List<RaySector.Places> sectors = new ArrayList<>();
    private RayConvolution convolution;
    private WavelengthNodes wavelengths;
    private double start;
    private double logStep;
    private int stride;
    private int count;

    RayOctave(RaySpectrum spectrum, double high, double step, double[] depths) {
        this.spectrum = spectrum;
        this.low = high / 2;
        this.depths = depths;
        this.widestStep = Math.min(step / high, WIDEST_STEP);
        this.rays = (int) Math.ceil(2 * Math.PI * high / step);
        int divided = Math.max(1, rays / SECTOR_RAYS);
        for (int i = 0; i < divided; i++) {
            sectors.add(new RaySector.Places(this, (int) ((long) rays * i / divided)));
        }
    }

    double low() {
        return low;
    }

    int rays() {
        return rays;
    }

    List<RaySector.Places> sectors() {
        return sectors;
    }

    /** Where a place lies among the rays, 0 to {@link #rays()}. */
    double ray(double u, double v) {
        double turns = Math.atan2(v, u) / (2 * Math.PI);
        return (turns < 0 ? turns + 1 : turns) * rays;
    }

    /** The number of a place's sector. */
    int sector(double u, double v) {
        int ray = Math.min(rays - 1, (int) ray(u, v));
        int at = (int) ((long) ray * sectors.size() / rays);
        while (at + 1 < sectors.size() && sectors.get(at + 1).firstRay() <= ray) {
            at++;
        }
        while (sectors.get(at).firstRay() > ray) {
            at--;
        }
        return at;
    }

    /** The first ray beyond a sector. */
    int end(RaySector.Places sector) {
        int next = sectors.indexOf(sector) + 1;
        return next < sectors.size() ? sectors.get(next).firstRay() : rays;
    }

    /** Made when the first sector needs it. */
    synchronized RayConvolution convolution() {
        if (convolution == null) {
            prepare(widestStep);
            int transform = transform(length(stride));
            for (double coarser = 1.01; length(stride) > transform; coarser += 0.01) {
                prepare(coarser * widestStep);
            }
            count = count(stride);
            start = Math.log(low) - QuinticSpline.MARGIN * placeStep();
            convolution = new RayConvolution(start, count, stride, wavelengths, depths, spectrum::coefficients);
        }
        return convolution;
    }

    /** As far from place to place as may be, but no farther than makes transforms shorter. */
    private void prepare(double widest) {
        wavelengths = spectrum.wavelengths(widest);
        double[] nodes = wavelengths.wavelengths();
        logStep = Math.log(nodes[nodes.length - 1] / nodes[0]) / (nodes.length - 1);
        if (stride == 0) {
            stride = Math.max(1, (int) (spectrum.widestPlaces() / logStep));
            int transform = transform(length(stride));
            while (stride > 1 && transform(length(stride - 1)) <= transform) {
                stride--;
            }
        }
    }

    /** How long the transforms are; by half shorter where they would be only a little longer than that. */
    private static int transform(int length) {
        int power = Integer.highestOneBit(length - 1);
        return length < LITTLE_LONGER * power ? power : 2 * power;
    }

    private double placeStep() {
        return stride * logStep;
    }

    private int count(int stride) {
        return 2 * QuinticSpline.MARGIN + 2 + (int) Math.ceil(Math.log(2) / (stride * logStep));
    }

    private int length(int stride) {
        return RayConvolution.length(count(stride), stride, wavelengths.count());
    }

    /** Places on a ray. */
    int count() {
        return count;
    }

    /** Where |(u, v)| lies among the places of a ray. */
    double onRay(double radius) {
        return (Math.log(radius) - start) / placeStep();
    }
}
