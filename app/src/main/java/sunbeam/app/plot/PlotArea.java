package sunbeam.app.plot;

import java.awt.geom.Rectangle2D;

/**
 * Where a matrix is drawn and which values its edges have.
 *
 * @param rectangle pixels
 * @param xRange values at the left and the right edge
 * @param yRange values at the lower and the upper edge
 */
record PlotArea(Rectangle2D rectangle, double[] xRange, double[] yRange) {
    double pixelX(double x) {
        return rectangle.getX() + (x - xRange[0]) / (xRange[1] - xRange[0]) * rectangle.getWidth();
    }

    double pixelY(double y) {
        return rectangle.getMaxY() - (y - yRange[0]) / (yRange[1] - yRange[0]) * rectangle.getHeight();
    }
}
