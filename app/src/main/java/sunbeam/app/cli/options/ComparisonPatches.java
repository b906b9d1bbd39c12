package sunbeam.app.cli.options;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import picocli.CommandLine.Option;
import sunbeam.app.terminal.Progress;
import sunbeam.app.terminal.ProgressDisplay;
import sunbeam.app.terminal.UsageException;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.setting.Choices;

/** Option {@code --with}, which adds surfaces to compare with the first; a picocli mixin. */
public final class ComparisonPatches {
    private static final int MOST = 24;

    @Option(
            names = "--with",
            paramLabel = "PATCH",
            description =
                    "Another surface to show beside it at the same exposure, with the same options; may be repeated.")
    private List<String> others = new ArrayList<>();

    public boolean areSeveral() {
        return !others.isEmpty();
    }

    /** Loads the first surface and the others. */
    public List<Patch> load(PatchOptions first, Choices method, ProgressDisplay display) {
        if (others.size() > MOST) {
            throw new UsageException("--with is given " + others.size() + " times; give it " + MOST + " times at most");
        }
        try (Progress progress = display.start("Reading the heights", 1 + others.size())) {
            List<Patch> patches = new ArrayList<>(List.of(first.load(method)));
            progress.step(1);
            for (String name : others) {
                patches.add(distinct(first.load(name, method), patches));
                progress.step(1);
            }
            return patches;
        }
    }

    /** Adds a number to the patch's name if an earlier patch has that name. */
    static Patch distinct(Patch patch, List<Patch> earlier) {
        Set<String> earlierNames = earlier.stream().map(Patch::name).collect(Collectors.toSet());
        String name = patch.name();
        for (int i = 2; earlierNames.contains(name); i++) {
            name = patch.name() + "-" + i;
        }
        return name.equals(patch.name())
                ? patch
                : patch.named(name, "renamed, since another surface has the name " + patch.name());
    }
}
