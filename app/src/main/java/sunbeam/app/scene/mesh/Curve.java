package sunbeam.app.scene.mesh;

/**
 * Smooth function through given points: monotone between them (Fritsch and Butland 1984), with zero slope at both ends and constant beyond.
 */
final class Curve {
    private final double[] x;
    private final double[] y;
    private final double[] slope;

    /** @param points x0, y0, x1, y1, ... with ascending x */
    Curve(double... points) {
        int count = points.length / 2;
        x = new double[count];
        y = new double[count];
        slope = new double[count];
        for (int i = 0; i < count; i++) {
            x[i] = points[2 * i];
            y[i] = points[2 * i + 1];
        }
        for (int i = 1; i < count - 1; i++) {
            double before = (y[i] - y[i - 1]) / (x[i] - x[i - 1]);
            double after = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
            // The harmonic mean keeps the cubic monotone; the slope is 0 at an extremum.
            slope[i] = before * after <= 0 ? 0 : 2 * before * after / (before + after);
        }
    }

    double at(double position) {
        int last = x.length - 1;
        if (position <= x[0]) {
            return y[0];
        }
        if (position >= x[last]) {
            return y[last];
        }
        int i = 0;
        while (position > x[i + 1]) {
            i++;
        }
        double width = x[i + 1] - x[i];
        double t = (position - x[i]) / width;
        double rest = 1 - t;
        return y[i] * rest * rest * (1 + 2 * t)
                + y[i + 1] * t * t * (3 - 2 * t)
                + width * (slope[i] * t * rest * rest - slope[i + 1] * t * t * rest);
    }
}
