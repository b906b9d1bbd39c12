package sunbeam.acceptance;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.function.IntBinaryOperator;
import javax.imageio.ImageIO;

public final class Images {
    private Images() {}

    /** Writes an 8-bit gray PNG with a value for each column and row. */
    public static Path gray(Path file, int columns, int rows, IntBinaryOperator value) throws IOException {
        BufferedImage image = new BufferedImage(columns, rows, BufferedImage.TYPE_BYTE_GRAY);
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                image.getRaster().setSample(column, row, 0, value.applyAsInt(column, row));
            }
        }
        ImageIO.write(image, "png", file.toFile());
        return file;
    }
}
