package jrtr.scene;

import jrtr.Tile;
import org.joml.Matrix4f;

/**
 * Part of a picture that a target shows. Pictures larger than the driver's largest target are drawn in parts.
 *
 * @param pictureWidth pixels per row of the whole picture
 * @param pictureHeight rows of the whole picture
 * @param part rectangle of the picture, of the target's size
 */
public record PictureArea(int pictureWidth, int pictureHeight, Tile part) {

    public PictureArea {
        if (!part.fitsIn(pictureWidth, pictureHeight)) {
            throw new IllegalArgumentException(
                    part + " is not inside a picture of " + pictureWidth + " x " + pictureHeight);
        }
    }

    public static PictureArea whole(int width, int height) {
        return new PictureArea(width, height, Tile.whole(width, height));
    }

    boolean isWhole() {
        return part.width() == pictureWidth && part.height() == pictureHeight;
    }

    /** Returns the part of the picture that a tile of the target shows. */
    PictureArea within(Tile tile) {
        return new PictureArea(pictureWidth, pictureHeight, part.part(tile));
    }

    Matrix4f wholeToPart() {
        double bottom = (double) pictureHeight - part.y() - part.height();
        double scaleX = (double) pictureWidth / part.width();
        double scaleY = (double) pictureHeight / part.height();
        double moveX = (pictureWidth - 2.0 * part.x() - part.width()) / part.width();
        double moveY = (pictureHeight - 2 * bottom - part.height()) / part.height();
        return new Matrix4f().translation((float) moveX, (float) moveY, 0).scale((float) scaleX, (float) scaleY, 1);
    }
}
