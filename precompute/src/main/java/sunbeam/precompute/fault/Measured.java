package sunbeam.precompute.fault;

import java.util.Optional;
import sunbeam.precompute.prepare.Crop;
import sunbeam.precompute.prepare.HeightField;

/**
 * The part of a scan that counts, in the whole of it.
 *
 * @param whole as it was measured
 * @param samples which of them count
 */
record Measured(HeightField whole, Crop.Samples samples) {

    static Measured of(HeightField whole, Optional<Crop> crop) {
        return new Measured(whole, crop.map(part -> part.samples(whole)).orElseGet(() -> Crop.Samples.allOf(whole)));
    }

    int columns() {
        return samples.endColumn() - samples.firstColumn();
    }

    int rows() {
        return samples.endRow() - samples.firstRow();
    }

    /** Metres; NaN or infinite where missing. */
    double at(int column, int row) {
        return whole.heights()[(samples.firstRow() + row) * whole.columns() + samples.firstColumn() + column];
    }

    /** As people count: from 1, at the top of the whole scan. */
    int number(int row) {
        return samples.firstRow() + row + 1;
    }

    /** The part of the whole scan with these rows and all columns that count. */
    Crop rows(int first, int end) {
        return new Crop.Samples(
                        samples.firstColumn(),
                        samples.endColumn(),
                        samples.firstRow() + first,
                        samples.firstRow() + end)
                .area(whole);
    }
}
