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

    /** Whether a part has fewer columns than count: those of a picture within its frame. */
    boolean isFramed(Crop part) {
        Crop.Samples within = part.samples(whole);
        return within.endColumn() - within.firstColumn() < columns();
    }

    /** The part of the whole scan with these rows and the columns that count, save what is a picture's frame. */
    Crop rows(int first, int end) {
        int[] columns = PictureFrame.columnsWithin(this, first, end);
        boolean framed = columns[1] - columns[0] < columns();
        int[] rows = framed ? PictureFrame.rowsWithin(this, columns, first, end) : new int[] {first, end};
        return new Crop.Samples(
                        samples.firstColumn() + columns[0],
                        samples.firstColumn() + columns[1],
                        samples.firstRow() + rows[0],
                        samples.firstRow() + rows[1])
                .area(whole);
    }
}
