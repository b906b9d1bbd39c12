package sunbeam.app.commands.brdfmap;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import sunbeam.app.files.plot.MapAnnotation;
import sunbeam.app.gpu.map.MapCaption;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.ScanLimit;
import sunbeam.precompute.setting.Choices;

/**
 * Maps with captions.
 *
 * @param index refractive, for people; empty for the default
 * @param exposed the exposure, for people
 * @param asked before scans' sizes limited them
 */
record AnnotatedMaps(Optional<String> index, String exposed, Choices asked) {
    private static final int WHITE = 0xffffffff;

    BufferedImage draw(MaterialMap.Drawn map, BufferedImage plain, Method method) {
        MapCaption.Remarks remarks =
                new MapCaption.Remarks(index, ScanLimit.of(asked, map.patch()).limiting());
        List<String> caption = MapCaption.of(map.patch(), map.light(), map.coherenceLength(), method, remarks);
        String white = burntOut(plain) ? "; white: brighter than this exposure shows" : "";
        return new MapAnnotation(plain, map.light(), MapCaption.with(caption, exposed + white)).draw();
    }

    /** Whether a direction is as bright as a screen can be; outside of the disc all is transparent. */
    static boolean burntOut(BufferedImage plain) {
        for (int y = 0; y < plain.getHeight(); y++) {
            for (int x = 0; x < plain.getWidth(); x++) {
                if (plain.getRGB(x, y) == WHITE) {
                    return true;
                }
            }
        }
        return false;
    }
}
