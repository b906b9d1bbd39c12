package sunbeam.app.measure.accuracy;

import java.util.ArrayList;
import java.util.List;
import jrtr.GraphicsException;
import sunbeam.app.measure.accuracy.MethodsFigure.Entry;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.method.Variant;
import sunbeam.precompute.setting.SettingException;

/** Where the methods stand, each in the forms that it names: error of X, Y, Z against the reference, and time per pixel. */
final class MethodsExperiment implements Experiment {
    @Override
    public int cost() {
        return 30;
    }

    @Override
    public Figure run(Subject subject) {
        List<Entry> entries = new ArrayList<>();
        List<String> remarks = new ArrayList<>();
        for (var type : Methods.ALL) {
            for (Variant variant : type.variants(subject.setup().surface())) {
                try {
                    entries.add(subject.methods().measure(variant.name(), variant.method(), variant.note()));
                } catch (GraphicsException | SettingException unmeasured) {
                    remarks.add(variant.name() + " was not measured: " + unmeasured.getMessage() + ".");
                }
            }
        }
        return new MethodsFigure(subject.name(), entries, remarks);
    }
}
