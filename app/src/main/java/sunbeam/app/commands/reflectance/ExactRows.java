package sunbeam.app.commands.reflectance;

import java.util.List;
import java.util.function.IntFunction;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.files.input.DirectionList;
import sunbeam.app.measure.errors.ExactColor;
import sunbeam.app.measure.errors.ExactPower;
import sunbeam.app.measure.errors.TableCertifier;
import sunbeam.precompute.method.Method;
import sunbeam.precompute.method.ReferenceMethod;
import sunbeam.precompute.plan.Average;

/** What the rows of a list of directions should hold: X, Y, Z, or the power of the average that is asked for. */
record ExactRows(DiffractionSetup setup, Method method, DirectionList list) {

    TableCertifier certifier(List<double[]> results) {
        if (list.spectral()) {
            // Columns power and power_ensemble.
            ReferenceMethod truth = method.exact(setup.patch().heights());
            int column = truth.area().average() == Average.ENSEMBLE ? 1 : 0;
            ExactPower exact = ExactPower.of(setup, method);
            return new TableCertifier(
                    row -> new double[] {results.get(row)[column]},
                    row -> new double[] {exact.power(list.pair(row), list.wavelength(row))},
                    "power");
        }
        ExactColor exact = ExactColor.of(setup, method);
        IntFunction<double[]> computed =
                row -> new double[] {results.get(row)[0], results.get(row)[1], results.get(row)[2]};
        return new TableCertifier(computed, row -> exact.xyz(list.pair(row)), "XYZ");
    }
}
