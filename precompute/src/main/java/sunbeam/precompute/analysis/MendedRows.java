package sunbeam.precompute.analysis;

import java.util.Optional;
import sunbeam.precompute.patch.HeightMap;

/**
 * A scan whose rows are moved back sideways by what a scanner slipped, so that a wave goes on across them. What a slip was is known
 * but for whole periods, which do not matter, and for noise, which widens the interval.
 */
final class MendedRows {
    // Standard deviations of all slips together.
    private static final double CERTAIN = 2;

    private final HeightMap map;
    private final RowSlips slipped;
    private final double frequencyX;
    private final double frequencyY;

    /**
     * @param map without missing samples
     * @param peak of its spectrum that the slips were found at
     */
    MendedRows(HeightMap map, SpectrumPeak peak, RowSlips slipped) {
        this.map = map;
        this.slipped = slipped;
        this.frequencyX = peak.frequencyX();
        // Slips have drawn the peak aside; between them rows turn as the wave does.
        this.frequencyY = peak.frequencyY() - slipped.turnsARow() / map.pitchY();
    }

    /** Empty where too few periods fit into the scan. */
    Optional<PeriodEstimate> estimate() {
        HeightMap mended = mended();
        return PeriodEstimator.ofOnePiece(mended, new SpectrumPeak(frequencyX, frequencyY, 0, 0))
                .map(this::withSlipsNoise);
    }

    private PeriodEstimate withSlipsNoise(PeriodEstimate told) {
        double turns = CERTAIN * slipped.deviation() * Math.sqrt(slipped.slips().size());
        // Of the period: by the share of the frequency that lies along the columns.
        double relative = turns / map.height() * Math.abs(frequencyY) / Math.pow(Math.hypot(frequencyX, frequencyY), 2);
        return told.within(told.low() * (1 - relative), told.high() * (1 + relative));
    }

    /** Without the columns at its sides that some row lacks. */
    private HeightMap mended() {
        int most = (int) Math.ceil(0.5 / (Math.abs(frequencyX) * map.pitchX())) + 1;
        int columns = map.columns() - 2 * most;
        double[] heights = new double[columns * map.rows()];
        double turns = 0;
        int next = 0;
        for (int row = 0; row < map.rows(); row++) {
            if (next < slipped.slips().size() && slipped.slips().get(next).row() == row) {
                turns += slipped.slips().get(next).turns();
                next++;
            }
            double moved = Math.IEEEremainder(turns, 1) / (frequencyX * map.pitchX());
            int whole = (int) Math.floor(moved);
            for (int column = 0; column < columns; column++) {
                heights[row * columns + column] = between(row, column + most - whole, moved - whole);
            }
        }
        return new HeightMap(columns, map.rows(), map.pitchX(), map.pitchY(), heights);
    }

    /** A share of the way from a column to the one on its left, by a line. */
    private double between(int row, int column, double share) {
        return (1 - share) * map.at(column, row) + share * map.at(column - 1, row);
    }
}
