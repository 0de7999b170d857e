package nephele.workshop.prove.process;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.LongPredicate;
import java.util.stream.LongStream;
import nephele.engine.level.Level;
import nephele.engine.level.Range;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;

/** A hundred of the odd levels of {@link InputsProof}. */
class InputsGlTest {
    private static final int LEVELS = 100;

    /** Odd numbers alone, spread over all levels and places, and as many pairs. */
    @Test
    void levelsOfOddNumbersAreRefusedOrServed() throws Exception {
        InputLevels levels = new InputLevels();
        long step = 2L * levels.numbersAlone() / LEVELS;
        long[] units = LongStream.range(0, LEVELS).map(i -> i * step + i % 7).toArray();
        // Skies of air and of weather take seconds each; the proof draws them, and other tests do.
        LongPredicate isDrawn = unit -> unit % 5 == 0
                && Set.of("room", "skybox", "ground").contains(levels.of(unit).name());
        ProofResult all = new InputsProof().run(units, isDrawn, Proof.Progress.NONE);
        assertEquals(List.of(), all.examples());
        assertTrue(all.value("refused") > 0 && all.value("accepted") > 0 && all.value("accepted and drawn") > 0);
    }

    @Test
    void everyNumberOfTheFormatIsInOneOfTheLevels() {
        Set<String> missing = new TreeSet<>();
        for (Class<?> record : records()) {
            for (RecordComponent component : record.getRecordComponents()) {
                if (component.isAnnotationPresent(Range.class)) {
                    missing.add(record.getName() + "." + component.getName());
                }
            }
        }
        new InputLevels()
                .levels().stream()
                        .flatMap(level -> level.places().stream())
                        .map(LevelNumbers.Place::component)
                        .forEach(component -> missing.remove(component.record().getName() + "."
                                + component.field().name()));
        assertEquals(Set.of(), missing, "add it to a level of nephele/workshop/prove/process");
    }

    /** Returns every record class of the level format. */
    private static List<Class<?>> records() {
        List<Class<?>> found = new ArrayList<>();
        Set<Class<?>> seen = new HashSet<>();
        Deque<Class<?>> open = new ArrayDeque<>(List.of(Level.class));
        while (!open.isEmpty()) {
            Class<?> type = open.pop();
            if (!seen.add(type)) {
                continue;
            } else if (type.isSealed()) {
                open.addAll(List.of(type.getPermittedSubclasses()));
            } else if (type.isRecord() && type.getName().startsWith("nephele.engine.level.")) {
                found.add(type);
                for (RecordComponent component : type.getRecordComponents()) {
                    open.addAll(types(component.getGenericType()));
                }
            }
        }
        return found;
    }

    private static List<Class<?>> types(Type type) {
        if (type instanceof ParameterizedType generic) {
            List<Class<?>> all = new ArrayList<>();
            for (Type argument : generic.getActualTypeArguments()) {
                all.addAll(types(argument));
            }
            return all;
        }
        return type instanceof Class<?> plain ? List.of(plain) : List.of();
    }
}
