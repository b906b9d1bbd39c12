package sunbeam.app.viewer.window;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.RadialGradientPaint;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.Stream;

/** Icon of the window: a spectrum around a light in the lower left corner. */
final class WindowIcon {
    private static final List<Color> COLORS = Stream.of(
                    0xfff4d0, 0x101418, 0x101418, 0x5030d0, 0x20a0ff, 0x30d060, 0xffe030, 0xff4020, 0x101418)
            .map(Color::new)
            .toList();
    private static final float[] RADII = {0, 0.2f, 0.4f, 0.5f, 0.6f, 0.7f, 0.8f, 0.9f, 1};

    private WindowIcon() {}

    static List<Image> images() {
        return Stream.of(16, 24, 32, 48, 64, 128).map(WindowIcon::image).toList();
    }

    private static Image image(int side) {
        BufferedImage image = new BufferedImage(side, side, BufferedImage.TYPE_INT_ARGB);
        Graphics2D graphics = image.createGraphics();
        graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        graphics.setPaint(new RadialGradientPaint(0, side, 1.1f * side, RADII, COLORS.toArray(Color[]::new)));
        graphics.fillRoundRect(0, 0, side, side, side / 4, side / 4);
        graphics.dispose();
        return image;
    }
}
