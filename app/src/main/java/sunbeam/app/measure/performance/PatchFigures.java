package sunbeam.app.measure.performance;

import java.util.List;

/**
 * What the methods cost on one patch.
 *
 * @param patch its name
 * @param rows one a method, the thesis's first
 * @param remarks what was not measured, and why
 */
record PatchFigures(String patch, List<Measured> rows, List<String> remarks) {
    PatchFigures {
        rows = List.copyOf(rows);
        remarks = List.copyOf(remarks);
    }

    /** Tables of colours alone. */
    List<Measured> baked() {
        return rows.stream().filter(row -> row.bake().isPresent()).toList();
    }
}
