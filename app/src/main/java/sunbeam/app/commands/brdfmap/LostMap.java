package sunbeam.app.commands.brdfmap;

import sunbeam.app.gpu.map.DiscDirections;
import sunbeam.app.gpu.picture.AutoExposure;
import sunbeam.app.gpu.picture.LinearPicture;
import sunbeam.precompute.optics.CoherenceWindow;

/** A map that the exposure it shares with others leaves black but for the mirror's light, and that its own would not. */
final class LostMap {
    /** Of white: lightness L* 4.5, black to an eye that sees white beside it. */
    private static final double DARK = 0.005;

    private LostMap() {}

    /**
     * Whether a map is lost.
     *
     * @param map linear X, Y, Z before exposure
     * @param directions that its pixels show
     * @param factor of the exposure that is shared
     */
    static boolean is(LinearPicture map, DiscDirections directions, CoherenceWindow window, double factor) {
        double brightest = brightestOutside(map, directions, window.mirrorReach());
        return brightest * factor < DARK && brightest * AutoExposure.of(map) >= DARK;
    }

    /** The largest of X, Y and Z, as a blue of little luminance is no black. */
    private static double brightestOutside(LinearPicture map, DiscDirections directions, double reach) {
        double brightest = 0;
        for (int pixel = 0; pixel < map.width() * map.height(); pixel++) {
            if (map.covered(pixel)) {
                var pair = directions.at(pixel);
                boolean outside = Math.hypot(pair.u(), pair.v()) > reach;
                for (int c = 0; outside && c < 3; c++) {
                    brightest = Math.max(brightest, map.xyz()[3 * pixel + c]);
                }
            }
        }
        return brightest;
    }
}
