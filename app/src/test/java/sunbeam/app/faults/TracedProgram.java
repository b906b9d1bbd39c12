package sunbeam.app.faults;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The program in a process of its own, alone or under strace, which counts its system calls or kills it at one. */
final class TracedProgram {
    /** What changes files and names, or begins to. */
    private static final String CALLS =
            "openat,open,creat,write,writev,pwrite64,pwritev,ftruncate,fallocate,fsync,fdatasync,"
                    + "link,linkat,symlink,symlinkat,rename,renameat,renameat2,unlink,unlinkat,mkdir,mkdirat,rmdir,chmod,fchmod,"
                    + "fchmodat,chown,fchown,lchown,fchownat,utimensat,setxattr,fsetxattr,sendfile,copy_file_range";

    private static final int KILLED = 128 + 9;
    private static final long MOST_MINUTES = 5;
    private static final Pattern CALL = Pattern.compile("^(\\d+) +(\\w+)\\(");
    /** In the name of a temporary file the process's number comes last but one. */
    private static final Pattern PROCESS = Pattern.compile("-\\d+(-\\d+\\.part)$");

    private final Path cache;
    private final Path said;

    /**
     * @param cache the folder for the cache's folder
     * @param said gets what the program says
     */
    TracedProgram(Path cache, Path said) {
        this.cache = cache;
        this.said = said;
    }

    /**
     * The calls that touch something in some folders.
     *
     * @param counts by the call's name
     * @param paths what they touch, with {@code $$} for the process's number
     */
    record Calls(Map<String, Integer> counts, Set<String> paths) {}

    /** Whether strace is there and may trace. */
    static boolean isPossible() throws IOException, InterruptedException {
        try {
            return new ProcessBuilder("strace", "-f", "-o", "/dev/null", "true")
                            .redirectErrorStream(true)
                            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                            .start()
                            .waitFor()
                    == 0;
        } catch (IOException missing) {
            return false;
        }
    }

    private static List<String> java(List<String> arguments) {
        List<String> words = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Djava.awt.headless=true",
                "-XX:TieredStopAtLevel=1",
                "-Djogamp.gluegen.UseTempJarCache=" + System.getProperty("jogamp.gluegen.UseTempJarCache", "true"),
                "-Djava.library.path=" + System.getProperty("java.library.path", ""),
                "-cp",
                System.getProperty("java.class.path"),
                "sunbeam.app.Main"));
        words.addAll(arguments);
        return words;
    }

    private int start(List<String> words) throws IOException, InterruptedException {
        ProcessBuilder builder =
                new ProcessBuilder(words).redirectErrorStream(true).redirectOutput(said.toFile());
        builder.environment().put("XDG_CACHE_HOME", cache.toString());
        Process process = builder.start();
        assertThat(process.waitFor(MOST_MINUTES, TimeUnit.MINUTES))
                .as("%s ended", words)
                .isTrue();
        return process.exitValue();
    }

    /** Runs it to its end. */
    void run(List<String> arguments) throws IOException, InterruptedException {
        assertThat(start(java(arguments))).as(Files.readString(said)).isZero();
    }

    /** Runs it to its end, and counts what it calls. */
    Calls count(List<String> arguments, List<Path> folders) throws IOException, InterruptedException {
        Path log = said.resolveSibling("calls.txt");
        List<String> words =
                new ArrayList<>(List.of("strace", "-f", "-q", "-y", "-o", log.toString(), "-e", "trace=" + CALLS));
        words.addAll(java(arguments));
        assertThat(start(words)).as(Files.readString(said)).isZero();

        Map<String, Integer> counts = new TreeMap<>();
        Map<String, String> threads = new HashMap<>();
        Set<String> paths = new TreeSet<>();
        for (String line : Files.readAllLines(log)) {
            Matcher call = CALL.matcher(line);
            Set<String> touched = touched(line, folders);
            if (call.find() && !touched.isEmpty()) {
                counts.merge(call.group(2), 1, Integer::sum);
                paths.addAll(touched);
                // strace counts by thread.
                assertThat(threads.putIfAbsent(call.group(2), call.group(1)))
                        .as("thread of " + line)
                        .isIn(null, call.group(1));
            }
        }
        return new Calls(counts, paths);
    }

    private static Set<String> touched(String line, List<Path> folders) {
        Set<String> touched = new TreeSet<>();
        for (Path folder : folders) {
            Matcher path = Pattern.compile(Pattern.quote(folder.toString()) + "(/[^\"<>]*)?(?=[\">])")
                    .matcher(line);
            while (path.find()) {
                touched.add(PROCESS.matcher(path.group()).replaceFirst("-\\$\\$$1"));
            }
        }
        return touched;
    }

    /**
     * Runs it until it is about to make a call for the n-th time, and kills it before the call is made.
     *
     * @param calls those that count
     * @param number from 1 on
     */
    void killAt(List<String> arguments, Calls calls, String call, int number) throws IOException, InterruptedException {
        // The shell's number is the program's, since the tracer is neither's parent.
        StringBuilder script = new StringBuilder("exec strace -D -f -q -o /dev/null");
        calls.paths().forEach(path -> script.append(" -P \"").append(path).append('"'));
        script.append(" -e trace=").append(call);
        script.append(" -e inject=").append(call).append(":signal=KILL:when=").append(number);
        script.append(" \"$@\"");
        List<String> words = new ArrayList<>(List.of("sh", "-c", script.toString(), "sh"));
        words.addAll(java(arguments));
        assertThat(start(words))
                .as("%s was killed at its %d. %s: %s", arguments, number, call, Files.readString(said))
                .isEqualTo(KILLED);
    }
}
