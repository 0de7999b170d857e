package nephele.lab.trade;

import java.io.IOException;
import java.io.StringReader;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import java.util.stream.Collectors;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.TextFile;
import nephele.lab.trade.SubjectState.Judged;

/** A subject's measurements in a file of its own, rewritten atomically after each new result. */
final class SubjectFile {
    private final Path file;
    private final String key;
    private final TradeSite site;

    /**
     * @param key a hash of the circumstances: measurements under others do not count
     * @param site the environment of the measurement: pictures by another renderer do not count
     */
    SubjectFile(Path folder, Trade trade, String key, TradeSite site) {
        this.site = site;
        file = folder.resolve(trade.subject() + ".properties");
        this.key = key + "; settings "
                + trade.settings().stream().map(Setting::name).collect(Collectors.joining(","));
    }

    /** Returns the measurements made under the same circumstances, else none. A damaged file counts as empty. */
    SubjectState load() throws IOException {
        if (!Files.exists(file)) {
            return SubjectState.NOTHING;
        }
        var saved = new Properties();
        try {
            saved.load(new StringReader(TextFile.text(Files.readAllBytes(file))));
            return isOfHere(saved) ? state(saved) : SubjectState.NOTHING;
        } catch (IllegalArgumentException | TextFile.NotUtf8 damaged) {
            return SubjectState.NOTHING;
        }
    }

    private boolean isOfHere(Properties saved) {
        return key.equals(saved.getProperty("key")) && site.drawsLike(saved.getProperty("graphics", ""));
    }

    /** Returns true if the file exists but holds nothing that was measured under the same circumstances. */
    boolean isOfAnotherRun() throws IOException {
        return Files.exists(file) && load().equals(SubjectState.NOTHING);
    }

    void save(SubjectState state) throws IOException {
        var saved = new Properties();
        saved.setProperty("key", key);
        saved.setProperty("graphics", site.graphics());
        for (int i = 0; i < state.judged().size(); i++) {
            var judged = state.judged().get(i);
            List<Double> numbers = new ArrayList<>(judged.figures());
            numbers.add(0, judged.error());
            saved.setProperty("judged." + i, (judged.hasPicture() ? "picture " : "number ") + words(numbers));
        }
        for (int i = 0; i < state.rounds().size(); i++) {
            List<Double> numbers = new ArrayList<>();
            state.rounds()
                    .get(i)
                    .forEach(cost -> numbers.addAll(List.of(cost.cpuNanos(), cost.wallNanos(), cost.bytes())));
            saved.setProperty("round." + i, words(numbers));
        }
        var text = new StringWriter();
        saved.store(text, null);
        AtomicFile.write(file, text.toString().getBytes(StandardCharsets.UTF_8));
    }

    private static SubjectState state(Properties saved) {
        List<Judged> judged = new ArrayList<>();
        for (int i = 0; saved.containsKey("judged." + i); i++) {
            String[] words = saved.getProperty("judged." + i).split(" ", 2);
            List<Double> numbers = numbers(words[1]);
            judged.add(new Judged(numbers.get(0), numbers.subList(1, numbers.size()), words[0].equals("picture")));
        }
        List<List<Cost>> rounds = new ArrayList<>();
        for (int i = 0; saved.containsKey("round." + i); i++) {
            List<Double> numbers = numbers(saved.getProperty("round." + i));
            List<Cost> costs = new ArrayList<>();
            for (int at = 0; at < numbers.size(); at += 3) {
                costs.add(new Cost(numbers.get(at), numbers.get(at + 1), numbers.get(at + 2)));
            }
            rounds.add(List.copyOf(costs));
        }
        return new SubjectState(List.copyOf(judged), List.copyOf(rounds));
    }

    private static String words(List<Double> numbers) {
        return numbers.stream().map(number -> Double.toString(number)).collect(Collectors.joining(" "));
    }

    private static List<Double> numbers(String words) {
        return java.util.Arrays.stream(words.split(" ")).map(Double::valueOf).toList();
    }
}
