package sunbeam.app.scene.mesh;

import static sunbeam.app.scene.texture.ScaleRelief.BEGIN;

import sunbeam.app.scene.texture.ScaleRelief;

/**
 * Positions of the snake's scales: texture coordinate u grows by the same amount with each scale, and a scale's length is proportional to
 * the body's width.
 */
public final class SnakeScales {
    // Half width of the body, in SnakeProfile.RADIUS, below which scales stop shrinking; smaller ones would be
    // invisible.
    private static final double NARROWEST = 0.2;
    private static final int SAMPLES = 4000;
    private static final SnakeScales SNAKE = new SnakeScales(new SnakeProfile());

    // Numbers of scales from the neck to each sample, up to a common factor: the integral of 1 / (half width in
    // SnakeProfile.RADIUS) over the body behind the head, whose length counts as 1.
    private final double[] lengths = new double[SAMPLES + 1];

    private SnakeScales(SnakeProfile profile) {
        for (int i = 1; i <= SAMPLES; i++) {
            double place = SnakeProfile.NECK + (1 - SnakeProfile.NECK) * (i - 0.5) / SAMPLES;
            double width = Math.max(NARROWEST, profile.halfWidth(place) / SnakeProfile.RADIUS);
            lengths[i] = lengths[i - 1] + 1 / (width * SAMPLES);
        }
    }

    static double u(double place) {
        if (place <= SnakeProfile.NECK) {
            return BEGIN * place / SnakeProfile.NECK;
        }
        double at = SAMPLES * (place - SnakeProfile.NECK) / (1 - SnakeProfile.NECK);
        int below = Math.min(SAMPLES - 1, (int) at);
        double length = SNAKE.lengths[below] + (at - below) * (SNAKE.lengths[below + 1] - SNAKE.lengths[below]);
        return BEGIN + (1 - BEGIN) * length / SNAKE.lengths[SAMPLES];
    }

    /** Returns the number of scales in a row for u from 0 to 1. */
    public static double perUnit(int rows) {
        // Width of a row in half widths of the body. The girth of the elliptic cross-section is about 5.8 half widths.
        double row = 5.8 * ScaleRelief.DORSAL / rows;
        double body = (1 - SnakeProfile.NECK) * SnakePath.LENGTH / SnakeProfile.RADIUS;
        return SNAKE.lengths[SAMPLES] * body / (row * ScaleRelief.LENGTH) / (1 - BEGIN);
    }
}
