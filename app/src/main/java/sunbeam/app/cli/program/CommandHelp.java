package sunbeam.app.cli.program;

import static sunbeam.precompute.method.Methods.METHOD;
import static sunbeam.precompute.plan.MethodSettings.COHERENCE_LENGTH;
import static sunbeam.precompute.plan.MethodSettings.TOLERANCE;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import picocli.CommandLine;
import picocli.CommandLine.Help;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.UsageMessageSpec;
import sunbeam.app.cli.LightOptions;
import sunbeam.app.scene.SceneSettings;
import sunbeam.precompute.patch.PatchSettings;
import sunbeam.precompute.plan.MethodSettings;
import sunbeam.precompute.setting.Setting;

/** Help of a command, with options in groups. The short form has the common options, each with the first sentence of its description. */
final class CommandHelp {
    static final String COMPLETE = "--help-all";
    private static final Set<String> LAST = Set.of("--output", "--force", "--resume", "--json");
    private static final Set<String> GENERAL = Set.of("--help", COMPLETE, "--version", "--debug", "--quiet");
    private static final List<Setting<?>> METHOD_SETTINGS =
            List.of(METHOD, MethodSettings.PRESET, TOLERANCE, COHERENCE_LENGTH, MethodSettings.AVERAGE);
    private static final Set<String> EXPERT =
            Set.of("--tone --primaries --linear --tev --light-cone --strokes --version --debug --quiet".split(" ", -1));
    // Settings that most users need.
    private static final Set<String> COMMON =
            Set.of(("--patch --width --max-height --mesh --texture --rotate-patch --exposure --theta-i --phi-i"
                            + " --illuminant --method --tolerance --coherence-length")
                    .split(" ", -1));
    private static final String EVERY = "Of every command";
    private static final String EXPERT_METHOD =
            "Method, for experts: parts of the plan that otherwise follow from the tolerance";
    private static final List<String> GROUPS =
            List.of("Options", "Surface", "Scene", "Light", "Method", EXPERT_METHOD, EVERY);

    private CommandHelp() {}

    static void install(CommandLine command, boolean complete) {
        Map<String, CommandLine.IHelpSectionRenderer> sections = command.getHelpSectionMap();
        sections.put(UsageMessageSpec.SECTION_KEY_OPTION_LIST_HEADING, help -> "");
        sections.put(UsageMessageSpec.SECTION_KEY_OPTION_LIST, help -> options(help, complete));
        if (!complete) {
            sections.remove(UsageMessageSpec.SECTION_KEY_EXIT_CODE_LIST_HEADING);
            sections.remove(UsageMessageSpec.SECTION_KEY_EXIT_CODE_LIST);
        }
    }

    private static String options(Help help, boolean complete) {
        StringBuilder text = new StringBuilder();
        for (String group : GROUPS) {
            CommandSpec members = CommandSpec.create();
            help.commandSpec().options().stream()
                    .filter(option -> group(option).equals(group))
                    .filter(option -> complete || isCommon(option))
                    .sorted(Comparator.comparing(option -> LAST.contains(option.longestName())))
                    .forEach(option -> members.addOption(shown(option, complete)));
            if (!members.options().isEmpty()) {
                Help.Layout layout = help.createDefaultLayout();
                layout.addAllOptions(members.options(), help.parameterLabelRenderer());
                text.append(help.createHeading("%n" + group + ":%n")).append(layout);
            }
        }
        return text.toString();
    }

    private static String group(OptionSpec option) {
        if (GENERAL.contains(option.longestName())) {
            return EVERY;
        }
        if (!(option.userObject() instanceof Setting<?> setting)) {
            return "Options";
        }
        if (setting.equals(SceneSettings.ROTATE_PATCH) || PatchSettings.ALL.contains(setting)) {
            return "Surface";
        }
        if (SceneSettings.OVERRIDABLE.contains(setting)) {
            return "Scene";
        }
        if (List.of(LightOptions.THETA_I, LightOptions.PHI_I).contains(setting)
                || MethodSettings.LIGHT.contains(setting)) {
            return "Light";
        }
        return METHOD_SETTINGS.contains(setting) ? "Method" : EXPERT_METHOD;
    }

    private static boolean isCommon(OptionSpec option) {
        return option.userObject() instanceof Setting<?>
                ? COMMON.contains(option.longestName())
                : !EXPERT.contains(option.longestName());
    }

    /** Returns a copy of an option for the help: in the short form, with the first sentence of its description and the default. */
    private static OptionSpec shown(OptionSpec option, boolean complete) {
        String[] sentences = String.join(" ", option.description()).split("(?<=\\.) (?=[A-Za-z-])");
        String shown = Arrays.stream(sentences)
                .filter(sentence -> complete || sentence.equals(sentences[0]) || sentence.startsWith("Default: "))
                .collect(Collectors.joining(" "));
        // picocli has already replaced %% by % and will format this text again.
        return OptionSpec.builder(option).description(shown.replace("%", "%%")).build();
    }
}
