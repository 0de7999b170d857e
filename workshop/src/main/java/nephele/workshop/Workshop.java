package nephele.workshop;

import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.List;
import java.util.stream.Collectors;
import nephele.app.Main;
import nephele.app.command.Command;
import nephele.app.command.CommandEntry;
import nephele.app.command.Commands;
import nephele.app.command.OptionRange;
import nephele.engine.reference.tile.Shard;
import nephele.host.terminal.CommandFailure;
import nephele.host.terminal.ExitCode;
import nephele.host.terminal.Terminal;
import nephele.lab.trade.Provenance;
import nephele.workshop.prove.ProofRun;
import nephele.workshop.prove.ProofTable;
import nephele.workshop.prove.Proofs;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** The main class of a checkout's commands: those of the jar, and the proofs. */
public final class Workshop {
    /** All commands in the order of the help text. */
    public static final List<CommandEntry> COMMANDS = Commands.ALL.stream()
            .map(entry -> entry.name().equals("prove")
                    ? new CommandEntry(entry.name(), entry.summary(), () -> new ProveCommand())
                    : entry)
            .toList();

    private Workshop() {}

    public static void main(String[] args) {
        Main.run(COMMANDS, args);
    }

    /** Runs the proofs at full count; a stopped run resumes where it was. */
    @picocli.CommandLine.Command
    private static final class ProveCommand implements Command {
        private static final long MOST_UNITS = 1_000_000_000_000L;
        private static final Path STATE_FOLDER = Path.of("build", "prove");
        private static final Path TABLE = Path.of("docs", "proofs.md");

        @Parameters(
                arity = "0..1",
                paramLabel = "NAME",
                description = "One proof; without it all of them run in order.")
        private String name;

        @Option(
                names = "--count",
                paramLabel = "N",
                description =
                        "Run only up to this many units; the figures are shown, but written to docs/proofs.md only with"
                                + " --record.")
        @OptionRange.Whole(least = 1, most = MOST_UNITS)
        private Long count;

        @Option(
                names = "--record",
                description = "With --count: write the figures all the same; the row says of how many.")
        private boolean record;

        @Option(
                names = "--from",
                paramLabel = "N",
                description =
                        "With --count: run these units from number N on alone, to repeat a failure; nothing is kept.")
        @OptionRange.Whole(least = 0, most = MOST_UNITS)
        private Long from;

        @Option(
                names = "--shard",
                paramLabel = "i/n",
                description =
                        "Run the i-th of n equal shares, for n processes; the last one to end writes the row of all.")
        private Shard shard;

        @Option(names = "--again", description = "Start over instead of going on where the last run stopped.")
        private boolean again;

        @Option(names = "--list", description = "List the proofs and their claims.")
        private boolean list;

        @Override
        public ExitCode run(Terminal terminal) throws Exception {
            if (list) {
                Proofs.ALL.forEach(proof -> terminal.out()
                        .println(proof.claim().name() + ": " + proof.claim().sentence()));
                return ExitCode.DONE;
            }
            if (from != null && (name == null || count == null || record || again)) {
                throw CommandFailure.usage("--from needs NAME and --count, and goes without --record and --again");
            }
            if (shard != null && (name == null || from != null)) {
                throw CommandFailure.usage("--shard needs NAME, and goes without --from");
            }
            boolean allHold = true;
            for (var proof : chosen()) {
                allHold &= prove(proof, terminal).holds();
            }
            return allHold ? ExitCode.DONE : ExitCode.INPUT;
        }

        private List<Proof> chosen() {
            if (name == null) {
                return Proofs.ALL;
            }
            var named = Proofs.ALL.stream()
                    .filter(proof -> proof.claim().name().equals(name))
                    .toList();
            if (named.isEmpty()) {
                var names =
                        Proofs.ALL.stream().map(proof -> proof.claim().name()).collect(Collectors.joining(", "));
                throw CommandFailure.usage("there is no proof `" + name + "`; there are: " + names);
            }
            return named;
        }

        private ProofResult prove(Proof proof, Terminal terminal) throws Exception {
            String commit = Provenance.commit();
            var run = new ProofRun(proof, STATE_FOLDER, shard == null ? Shard.WHOLE : shard, terminal.err());
            if (from != null) {
                var result = run.alone(from, count);
                terminal.out().println(ProofTable.summary(proof, result));
                return result;
            }
            if (again) {
                run.startOver(commit);
            }
            run.upTo(count == null ? run.size() : Math.min(count, run.size()), commit);
            var result = run.joined(commit);
            terminal.out().println(ProofTable.summary(proof, result));
            if (record || result.units() >= proof.claim().fullCount()) {
                String date = LocalDate.now(ZoneOffset.UTC).toString();
                new ProofTable(TABLE).write(proof, result, date, commit, Provenance.machine());
            }
            return result;
        }
    }
}
