package sunbeam.app.commands.figures;

import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.Map;
import java.util.OptionalDouble;
import sunbeam.app.files.cache.DiffractionSetup;
import sunbeam.app.terminal.Environment;
import sunbeam.app.terminal.UsageException;
import sunbeam.app.terminal.options.PatchOptions;
import sunbeam.precompute.patch.PatchRequest;

/** The patches of the figures, loaded once each when they are needed first. */
final class FigurePatches {
    private final Path folder;
    private final Environment environment;
    private final PrintWriter err;
    private final Map<Role, DiffractionSetup> loaded = new EnumMap<>(Role.class);

    /**
     * Built-in patches, or measured ones.
     *
     * @param folder with blaze.json, elaphe.json and xenopeltis.json; null for the built-in ones
     * @throws UsageException when a descriptor is missing
     */
    FigurePatches(Path folder, Environment environment, PrintWriter err) {
        this.folder = folder;
        this.environment = environment;
        this.err = err;
        for (Role role : Role.values()) {
            if (folder != null && !Files.isRegularFile(descriptor(role))) {
                throw new UsageException("--patches " + folder + ": there is no " + role.label()
                        + ".json; give a folder with blaze.json, elaphe.json and xenopeltis.json");
            }
        }
    }

    private Path descriptor(Role role) {
        return folder.resolve(role.label() + ".json");
    }

    DiffractionSetup setup(Role role) {
        return loaded.computeIfAbsent(role, this::load);
    }

    private DiffractionSetup load(Role role) {
        String named = folder == null ? role.builtIn() : descriptor(role).toString();
        return new DiffractionSetup(PatchOptions.load(PatchRequest.of(named)), environment, err);
    }

    /**
     * Direction of the grating for Table 4.1, radians: 0, and 100 degrees for the measured Xenopeltis, whose azimuth
     * the thesis does not state; empty, to be found, for the built-in skins.
     */
    OptionalDouble azimuth(Role role) {
        if (role == Role.BLAZE) {
            return OptionalDouble.of(0);
        }
        if (folder == null) {
            return OptionalDouble.empty();
        }
        return OptionalDouble.of(role == Role.XENOPELTIS ? Math.toRadians(100) : 0);
    }
}
