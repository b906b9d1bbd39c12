package sunbeam.acceptance;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

class LauncherStartTest extends InSandbox {
    @Test
    void theRealProgramAnswersHelpWithoutBuilding() throws Exception {
        SunbeamResult result =
                Sunbeam.command("--help").without("DISPLAY").in(folder).run().ended(0);
        assertThat(result.stderr()).as("%s", result).isEmpty();
    }

    @Test
    void argumentsAndWorkingFolderReachTheProgramUnchanged() throws Exception {
        Path elsewhere = Files.createDirectories(folder.resolve("some where"));

        SunbeamResult result = command("inspect", "a b", "", "*.png", "../up")
                .in(elsewhere)
                .run()
                .ended(0);
        assertThat(result.stdout().lines().skip(1))
                .startsWith(elsewhere.toRealPath().toString())
                .endsWith("sunbeam.app.Main", "inspect", "a b", "", "*.png", "../up");
    }

    @Test
    void findsItsRepositoryThroughASymbolicLinkAndBlanks() throws Exception {
        Path link = folder.resolve("sunbeam link");
        Files.createSymbolicLink(link, launcher());

        SunbeamResult result = equip(Sunbeam.launcher(link, "inspect")).run();

        Path repository = repository().toRealPath();
        result.ended(0);
        assertThat(result.stdout().lines())
                .contains("-Dsunbeam.home=" + repository)
                .anyMatch(line -> line.matches(Pattern.quote(repository + "/app/target/run/") + "([-0-9]+)/\\*:"
                        + Pattern.quote(repository + "/app/target/run/") + "\\1/lib/\\*"));
    }

    /** Java would warn, on standard output if it may, about a class archive that was made for another folder. */
    @Test
    void aCopiedCheckoutHasAClassArchiveOfItsOwnAndJavaIsSilentAboutIt() throws Exception {
        command("inspect").run();
        Path copied = folder.resolve("copied");
        Process copying = new ProcessBuilder("cp", "-a", repository().toString(), copied.toString()).start();
        assertThat(copying.waitFor()).isZero();

        SunbeamResult result =
                equip(Sunbeam.launcher(copied.resolve("sunbeam"), "inspect")).run();

        Path runs = copied.toRealPath().resolve("app/target/run");
        assertThat(result.stdout().lines())
                .contains("-Xlog:disable", "-Xlog:all=error:stderr")
                .anyMatch(line -> line.matches(
                        "-XX:SharedArchiveFile=" + Pattern.quote(runs.toString()) + "/[-0-9]+/classes.jsa"));
    }

    /** Mesa maps its cache of shaders into memory: on a full disk that would kill Java. */
    @Test
    void aFullDiskNeitherKillsJavaNorDoesADeadJavaLeaveFilesInTheUsersFolder() throws Exception {
        installJava("jdk", "17.0.1", "echo \"Mesa $MESA_SHADER_CACHE_DISABLE $MESA_GLSL_CACHE_DISABLE\"");
        installProgram("df", "echo Filesystem", "echo /dev/disk 100000000 99999000 1000 100% /");

        assertThat(command("brdf-map")
                        .with("DISPLAY", "elsewhere:0")
                        .run()
                        .stdout()
                        .lines())
                .contains(
                        "-XX:ErrorFile=/dev/null", "-XX:-CreateCoredumpOnCrash", "-XX:-UsePerfData", "Mesa true true");
    }

    /** A shell with {@code set -f} passes that on in SHELLOPTS. */
    @Test
    void aShellWithoutPatternsStartsTheProgram() throws Exception {
        SunbeamResult result =
                command("inspect").with("SHELLOPTS", "noglob:noclobber").run().ended(0);
        assertThat(result.stdout()).contains("sunbeam.app.Main");
    }

    @Test
    void aFolderThatHasGoneIsALineOfOurs() throws Exception {
        Process process = new ProcessBuilder(
                        "bash",
                        "-c",
                        "mkdir gone; cd gone; rmdir ../gone; exec \"$0\" inspect",
                        launcher().toString())
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .start();

        assertThat(new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8))
                .endsWith("sunbeam: the current folder does not exist any more: change to another (cd)\n");
        assertThat(process.waitFor()).isEqualTo(2);
    }

    @Test
    void aPathWithoutBashIsALineOfOurs() throws Exception {
        SunbeamResult result =
                command("inspect").with("PATH", folder.toString()).run().ended(7);
        assertThat(result.stderr())
                .isEqualTo("sunbeam: there is no bash on the PATH (" + folder + "); add the folder that has it\n");
    }

    @Test
    void passesOverAJavaThatIsTooOld() throws Exception {
        installJava("old jdk", "11.0.2", "exit 11");
        installJava("jdk", "17.0.1", "exit 17");
        String path = folder.resolve("jdk/bin") + ":" + folder.resolve("programs") + ":" + System.getenv("PATH");

        command("inspect")
                .with("JAVA_HOME", folder.resolve("old jdk").toString())
                .with("PATH", path)
                .run()
                .ended(17);
    }
}
