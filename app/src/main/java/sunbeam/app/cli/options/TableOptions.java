package sunbeam.app.cli.options;

import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.util.Map;
import java.util.stream.Stream;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.plan.LightSettings;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/**
 * Options of commands that compute a color table for all directions: surface, tolerance, coherence length, spectrum of the light; a picocli
 * mixin.
 */
public final class TableOptions extends SettingOptions {
    @Parameters(paramLabel = "PATCH", description = "A built-in patch, a descriptor (.json) or a scan.")
    private String patch;

    @Mixin
    private final PatchOptions surface = PatchOptions.withoutPatch();

    /**
     * Makes the options.
     *
     * @param helpTexts text of the help for each default that the command itself applies
     */
    public TableOptions(Map<Setting<?>, String> helpTexts) {
        super(
                Stream.concat(Stream.of(TOLERANCE, COHERENCE_LENGTH), LightSettings.ALL.stream())
                        .toList(),
                helpTexts);
    }

    /**
     * Reads the patch that the positional argument names.
     *
     * @param asked choices of the method; preset {@code thesis} reads the file as the thesis does
     */
    public Patch load(Choices asked) {
        return surface.load(patch, asked);
    }
}
