package nephele.mutants;

import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * Runs mutants, all of them or COUNT from number FROM on, and prints a line for each: {@code killed} or {@code
 * SURVIVED}, area, name, test, evidence.
 */
public final class AllMutants {
    private AllMutants() {}

    public static void main(String[] range) throws Exception {
        int from = range.length == 2 ? Integer.parseInt(range[0]) : 0;
        int count = range.length == 2 ? Integer.parseInt(range[1]) : Mutants.ALL.size();
        PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
        MutantRun run = new MutantRun(Files.createDirectories(Path.of("build", "mutants")));
        List<Mutant> mutants = Mutants.ALL.subList(from, Math.min(from + count, Mutants.ALL.size()));
        run.requireGreen(mutants);
        for (Mutant mutant : mutants) {
            MutantRun.Verdict verdict = run.judge(mutant);
            String state = verdict.killed() ? "killed" : "SURVIVED";
            out.println(String.join(
                    " | ", state, mutant.area().name(), mutant.name(), mutant.killer(), verdict.evidence()));
        }
    }
}
