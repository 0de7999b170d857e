package nephele.engine.level;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import nephele.engine.asset.LevelAssets;
import nephele.engine.asset.SamplePictures;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.rule.LevelRules;

/** The answers of {@code check} to each bad level; also run as a process of its own, to limit its memory. */
final class BadLevelRun {
    private BadLevelRun() {}

    static List<BadLevel> all() {
        List<BadLevel> all = new ArrayList<>(BadDocuments.ALL);
        all.addAll(BadValues.ALL);
        all.addAll(BadRelations.ALL);
        all.addAll(BadBillboards.ALL);
        all.addAll(BadObservers.ALL);
        all.addAll(BadHints.ALL);
        all.addAll(BadImpostors.ALL);
        return all;
    }

    /** Writes the assets that some levels name. */
    static void prepare(Path folder) throws IOException {
        byte[] good = SamplePictures.png(4, 4, 8, 2, 1);
        Path inside = Files.createDirectories(folder.resolve("levels"));
        Files.write(folder.resolve("real.png"), good);
        Files.write(inside.resolve("real.png"), good);
        Files.write(inside.resolve("wide.png"), SamplePictures.png(8, 4, 8, 2, 1));
        Files.write(inside.resolve("large.png"), SamplePictures.png(8, 8, 8, 2, 1));
        Files.createDirectories(inside.resolve("folder"));
        Files.createSymbolicLink(inside.resolve("loop.png"), inside.resolve("loop.png"));
        Files.createSymbolicLink(inside.resolve("outside.png"), folder.resolve("real.png"));
        Files.write(inside.resolve("bomb.png"), SamplePictures.png(SamplePictures.header(100_000, 100_000, 8, 6, 0)));
        Files.write(inside.resolve("thin.png"), SamplePictures.png(SamplePictures.header(8192, 8192, 8, 6, 0)));
        Files.write(inside.resolve("zero.png"), SamplePictures.png(SamplePictures.header(0, 4, 8, 6, 0)));
        byte[] sum = good.clone();
        sum[30] ^= 1;
        Files.write(inside.resolve("sum.png"), sum);
        Files.write(inside.resolve("cut.png"), Arrays.copyOf(good, good.length - 20));
        Files.writeString(inside.resolve("text.png"), "no picture");
        Files.write(inside.resolve("empty.png"), new byte[0]);
        Files.write(inside.resolve("cut.tga"), new byte[10]);
        byte[] run = {(byte) 0x84, 1, 2, 3};
        Files.write(inside.resolve("run.tga"), SamplePictures.tga(10, 2, 2, 24, run));
        Files.write(inside.resolve("short-run.tga"), SamplePictures.tga(10, 3, 2, 24, run));
        Files.write(inside.resolve("palette.tga"), SamplePictures.paletteTga(1, new byte[] {0, 1, 2, 0}));
        Files.write(inside.resolve("palette-run.tga"), SamplePictures.paletteTga(9, new byte[] {(byte) 0x83, 2}));
        Files.write(inside.resolve("wide.tga"), SamplePictures.tga(2, 65535, 65535, 24, new byte[9]));
    }

    /** Returns the lines that {@code check} prints. */
    static List<String> lines(Path folder, BadLevel bad) throws IOException {
        Path file = folder.resolve("levels/bad.json");
        byte[] content = bad.content().get();
        Files.write(file, content);
        List<Problem> problems;
        try {
            problems = LevelRules.checkRecordsAndFiles(LevelFile.read(file), LevelAssets.beside(file));
        } catch (LevelFormatException told) {
            problems = told.problems();
        }
        if (!Arrays.equals(content, Files.readAllBytes(file))) {
            throw new IllegalStateException("the file has changed");
        }
        return problems.stream()
                .filter(Problem::isError)
                .map(problem -> problem.line("bad.json"))
                .toList();
    }

    /** Returns the error in the answer to {@code bad}, or {@code null}. */
    static String objection(Path folder, BadLevel bad) throws IOException {
        List<String> lines = lines(folder, bad);
        if (lines.isEmpty()) {
            return bad + ": was accepted";
        }
        if (lines.stream()
                .noneMatch(line -> line.startsWith("bad.json: " + bad.path()) && line.contains(bad.words()))) {
            return bad + ": no line has path '" + bad.path() + "' and '" + bad.words() + "': " + lines;
        }
        return lines.stream().anyMatch(line -> line.length() > 1000) ? bad + ": a line is too long to read" : null;
    }

    /**
     * Prints wrong answers, normally nothing; without an argument, the CPU time of each kind in its first run, for
     * {@code docs/performance.md}.
     *
     * @param arguments the folder that was prepared
     */
    public static void main(String[] arguments) throws IOException {
        Path folder = arguments.length > 0 ? Path.of(arguments[0]) : Files.createTempDirectory("bad-levels");
        if (arguments.length == 0) {
            prepare(folder);
        }
        for (BadLevel bad : all()) {
            long before = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
            String objection = objection(folder, bad);
            long nanoseconds = ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime() - before;
            if (objection != null) {
                System.out.println(objection);
            } else if (arguments.length == 0) {
                System.out.printf(Locale.ROOT, "%7.1f ms  %s%n", nanoseconds / 1e6, bad);
            }
        }
    }
}
