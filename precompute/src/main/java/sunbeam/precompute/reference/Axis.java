package sunbeam.precompute.reference;

import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.optics.WindowOrigin;

/**
 * Sample positions along one axis, relative to the sample under the window's maximum.
 *
 * @param step signed distance of neighboring samples in meters; negative along y, because rows run downwards
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
}
