package jrtr;

import java.util.ArrayList;
import java.util.List;

/** A rectangle of at least one pixel of an image, x columns from its left and y rows from its top. */
public record Tile(int x, int y, int width, int height) {

    public static Tile whole(int width, int height) {
        return new Tile(0, 0, width, height);
    }

    public List<Tile> divide(int side) {
        return divide(side, side);
    }

    /** Returns tiles that cover this one exactly once, row by row from the top left; those at the right and the bottom are cut. */
    public List<Tile> divide(int columns, int rows) {
        if (columns < 1 || rows < 1) {
            throw new IllegalArgumentException("tile side " + Math.min(columns, rows) + " is below 1");
        }
        List<Tile> tiles = new ArrayList<>();
        for (long down = 0; down < height; down += rows) {
            for (long right = 0; right < width; right += columns) {
                int partWidth = (int) Math.min(columns, width - right);
                int partHeight = (int) Math.min(rows, height - down);
                tiles.add(new Tile(x + (int) right, y + (int) down, partWidth, partHeight));
            }
        }
        return List.copyOf(tiles);
    }

    public long pixels() {
        return (long) width * height;
    }

    public boolean fitsIn(int imageWidth, int imageHeight) {
        boolean isRectangle = x >= 0 && y >= 0 && width > 0 && height > 0;
        return isRectangle && (long) x + width <= imageWidth && (long) y + height <= imageHeight;
    }
}
