package sunbeam.app.commands.reflectance;

import java.util.List;
import java.util.function.IntFunction;
import sunbeam.app.files.input.DirectionList;
import sunbeam.app.measure.errors.TableCertifier;
import sunbeam.precompute.reference.ExactLight;
import sunbeam.precompute.reference.ReferenceColor.Quadrature;

/** What the rows of a list of directions should hold: X, Y, Z, or the power of the average that is asked for. */
record ExactRows(ExactLight exact, DirectionList list) {

    TableCertifier certifier(List<double[]> results) {
        if (list.spectral()) {
            // Coherent power, ensemble's power.
            int column = exact.ensemble() ? 1 : 0;
            return new TableCertifier(
                    row -> new double[] {results.get(row)[column]},
                    row -> new double[] {exact.power(list.pair(row), list.wavelength(row))},
                    "power");
        }
        IntFunction<double[]> computed =
                row -> new double[] {results.get(row)[0], results.get(row)[1], results.get(row)[2]};
        return new TableCertifier(computed, row -> exact.xyz(list.pair(row), Quadrature.INTEGRATED), "XYZ");
    }
}
