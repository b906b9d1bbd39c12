package sunbeam.app.terminal.options;

import sunbeam.app.terminal.SettingOptions;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.PatchLoader;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.patch.builtin.BuiltInPatches;

/** Which surface; to be used as a picocli mixin. */
public final class PatchOptions extends SettingOptions {
    public PatchOptions() {
        super(PatchSettings.ALL);
    }

    /** Loads the patch; nothing else is read before it is known to be usable. */
    public Patch load() {
        return load(new PatchRequest(choices()));
    }

    /** As {@link #load()}, with a patch named elsewhere than by the option. */
    public Patch load(String named) {
        return load(new PatchRequest(choices().with(PatchSettings.PATCH, named)));
    }

    /** Loads a patch that is asked for elsewhere; built-in names are known. */
    public static Patch load(PatchRequest request) {
        return new PatchLoader(BuiltInPatches.names(), BuiltInPatches::generate).load(request);
    }
}
