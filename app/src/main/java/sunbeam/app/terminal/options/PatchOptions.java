package sunbeam.app.terminal.options;

import java.util.ArrayList;
import java.util.List;
import sunbeam.app.terminal.SettingOptions;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.PatchLoader;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.plan.Preset;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/** Which surface; to be used as a picocli mixin. */
public final class PatchOptions extends SettingOptions {
    public PatchOptions() {
        this(PatchSettings.ALL);
    }

    private PatchOptions(List<Setting<?>> settings) {
        super(settings);
    }

    /** Options for surfaces that a command names by itself. */
    public static PatchOptions ofSeveral() {
        return new PatchOptions(PatchSettings.ALL.stream()
                .filter(setting -> !setting.equals(PatchSettings.PATCH))
                .toList());
    }

    /** Loads several, with names that differ, as a method's preset takes them. */
    public List<Patch> load(List<String> names, Choices method) {
        List<Patch> patches = new ArrayList<>();
        names.forEach(name -> patches.add(ComparedPatches.distinct(load(name, method), patches)));
        return patches;
    }

    /** Loads the patch; nothing else is read before it is known to be usable. */
    public Patch load() {
        return PatchLoader.load(new PatchRequest(choices()));
    }

    /** As {@link #load()}, as a method's preset takes it. */
    public Patch load(Choices method) {
        return PatchLoader.load(new PatchRequest(choices()).raw(isThesis(method)));
    }

    /** As {@link #load(String)}, as a method's preset takes it. */
    public Patch load(String named, Choices method) {
        return PatchLoader.load(new PatchRequest(choices().with(PatchSettings.PATCH, named)).raw(isThesis(method)));
    }

    private static boolean isThesis(Choices method) {
        return Preset.isThesis(method);
    }

    /** As {@link #load()}, with a patch named elsewhere than by the option. */
    public Patch load(String named) {
        return PatchLoader.load(new PatchRequest(choices().with(PatchSettings.PATCH, named)));
    }
}
