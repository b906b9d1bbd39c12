package sunbeam.app.cli;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import picocli.CommandLine.Option;
import sunbeam.app.terminal.Messages;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.precompute.method.MethodPlan;
import sunbeam.precompute.method.MethodType;
import sunbeam.precompute.method.Methods;
import sunbeam.precompute.plan.Average;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.plan.SpectrumPlan;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.text.Text;

/** Options of the method and its settings; a picocli mixin. */
public final class MethodOptions extends SettingOptions {
    @Option(names = "--explain", description = "State the reason of each part of the plan.")
    private boolean explain;

    public MethodOptions() {
        this(Map.of());
    }

    public MethodOptions(Map<Setting<?>, String> helpTexts) {
        super(Methods.SETTINGS, helpTexts);
    }

    private MethodOptions(List<Setting<?>> settings) {
        super(settings);
    }

    /** Returns the options that at least one of these methods has, and {@code --method} if there are several. */
    public static MethodOptions of(MethodType... types) {
        List<Setting<?>> method = types.length > 1 ? List.of(Methods.METHOD) : List.of();
        List<Setting<?>> settings = new ArrayList<>();
        Arrays.stream(types).forEach(type -> settings.addAll(type.settings()));
        return new MethodOptions(Setting.union(method, settings));
    }

    /** Returns the options of commands that compute a color table for all directions. */
    public static SettingOptions ofTables(Map<Setting<?>, String> helpTexts) {
        List<Setting<?>> own = List.of(MethodSettings.TOLERANCE, MethodSettings.COHERENCE_LENGTH);
        return new SettingOptions(Setting.union(own, MethodSettings.LIGHT), helpTexts);
    }

    /** Returns the choices with the ensemble average if none is chosen and the method has it: a single coherence area shows speckle. */
    public static Choices averaged(Choices chosen) {
        boolean open = !chosen.has(MethodSettings.AVERAGE) && !Preset.isThesis(chosen);
        return open && chosen.get(Methods.METHOD).has(MethodSettings.AVERAGE)
                ? chosen.with(MethodSettings.AVERAGE, Average.ENSEMBLE)
                : chosen;
    }

    public boolean explains() {
        return explain;
    }

    public void explain(SpectrumPlan plan, PrintWriter out) {
        if (explain) {
            print("plan: ", plan.summary(), plan.reasons(), out);
        }
    }

    /**
     * Prints a method's plan, its reasons if {@code --explain} is given, and its warnings.
     *
     * @param patch name of one of several patches; empty for a single one
     */
    public void print(String patch, MethodPlan method, PrintWriter out) {
        print(patch, method, method.summary(), out);
    }

    /** @param summary of the plan, with what a command adds to it */
    void print(String patch, MethodPlan method, String summary, PrintWriter out) {
        String name = patch.isEmpty() ? "" : Text.oneLine(patch) + ": ";
        print("plan: " + name, summary, method.reasons(), out);
        method.warnings().forEach(line -> out.println(Messages.warning(line.in(OptionOrigin.INSTANCE))));
    }

    /** Prints the result of a color table's validation, which is empty for methods without a table. */
    public void printTrial(String trial, PrintWriter out) {
        if (!trial.isEmpty()) {
            out.println("table: " + trial);
        }
    }

    private void print(String title, String summary, List<String> reasons, PrintWriter out) {
        out.println(title + summary);
        if (explain) {
            reasons.forEach(line -> out.println("  " + line));
        }
    }
}
