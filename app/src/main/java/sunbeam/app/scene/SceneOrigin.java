package sunbeam.app.scene;

import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.app.cli.UsageException;
import sunbeam.app.input.InputException;
import sunbeam.app.json.JsonObject;
import sunbeam.app.json.JsonValue;
import sunbeam.precompute.patch.PatchException;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;

/**
 * Where a scene's patch and plan are written, so that what is wrong with them, found out only when they are loaded, names
 * file, line and key. It is no part of what a scene is: all origins are equal.
 */
public final class SceneOrigin {
    /** Of scenes that no file holds: what is wrong is said in the command line's words. */
    static final SceneOrigin NONE = new SceneOrigin(Optional.empty(), Optional.empty());

    private static final Pattern OPTION = Pattern.compile("(?<![\\w-])--([a-z]+(?:-[a-z]+)*)");
    private static final Pattern HYPHEN = Pattern.compile("-([a-z])");

    private final Optional<JsonObject> patch;
    private final Optional<JsonObject> plan;

    private SceneOrigin(Optional<JsonObject> patch, Optional<JsonObject> plan) {
        this.patch = patch;
        this.plan = plan;
    }

    /** @param root the whole file, with the keys {@code patch} and {@code plan} */
    static SceneOrigin of(JsonObject root) {
        return new SceneOrigin(Optional.of(root), Optional.of(root));
    }

    /** With a patch from elsewhere. */
    SceneOrigin withoutPatch() {
        return new SceneOrigin(Optional.empty(), plan);
    }

    /** With a method or plan from elsewhere. */
    SceneOrigin withoutPlan() {
        return new SceneOrigin(patch, Optional.empty());
    }

    /**
     * Loads the patch.
     *
     * @throws InputException in place of a PatchException where the patch is written in a file
     */
    <T> T patch(Supplier<T> loading) {
        try {
            return loading.get();
        } catch (PatchException failure) {
            throw patch.<RuntimeException>map(root -> complaint(root, "patch", failure))
                    .orElse(failure);
        }
    }

    /**
     * Plans.
     *
     * @throws InputException in place of a UsageException or SettingException where the plan is written in a file
     */
    <T> T plan(Supplier<T> planning) {
        try {
            return planning.get();
        } catch (UsageException failure) {
            throw plan.<RuntimeException>map(root -> complaint(root, "plan", failure))
                    .orElse(failure);
        } catch (SettingException failure) {
            throw plan.<RuntimeException>map(root -> complaint(root, failure)).orElse(failure);
        }
    }

    private static InputException complaint(JsonObject root, SettingException failure) {
        InputException complaint = failure.problem().parts().stream()
                .filter(Setting.class::isInstance)
                .map(part -> ((Setting<?>) part).key())
                .filter(key -> root.object("plan", "").has(key))
                .findFirst()
                .map(key -> root.object("plan", "").complaint(key, failure.getMessage()))
                .orElseGet(() -> root.complaint("plan", failure.getMessage()));
        complaint.initCause(failure);
        return complaint;
    }

    private static InputException complaint(JsonObject root, String part, RuntimeException failure) {
        InputException complaint = complaint(root, part, failure.getMessage());
        complaint.initCause(failure);
        return complaint;
    }

    /** About the first key that the message speaks of and the file has; else about the whole part. */
    private static InputException complaint(JsonObject root, String part, String message) {
        Matcher options = OPTION.matcher(message);
        String problem = options.replaceAll(SceneOrigin::key);
        if (root.find(part).filter(JsonValue.Members.class::isInstance).isEmpty()) {
            return root.complaint(part, problem);
        }
        JsonObject keys = root.object(part, "");
        return options.reset()
                .results()
                .map(SceneOrigin::key)
                .filter(keys::has)
                .findFirst()
                .map(key -> keys.complaint(key, problem))
                .orElseGet(() -> root.complaint(part, problem));
    }

    /** Options are called as the scene's keys: {@code --max-height} is {@code maxHeight}. */
    private static String key(MatchResult option) {
        String name = option.group(1);
        return name.equals("level")
                ? "levelling"
                : HYPHEN.matcher(name).replaceAll(hyphen -> hyphen.group(1).toUpperCase(Locale.ROOT));
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof SceneOrigin;
    }

    @Override
    public int hashCode() {
        return 0;
    }

    @Override
    public String toString() {
        return patch.isPresent() || plan.isPresent() ? "from a file" : "from no file";
    }
}
