package nephele.engine.portal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** Crossing words obey the laws of reduced words, with portals as letters and partners as inverses. */
final class CrossingWordTest {
    private static final int LETTERS = 6;

    private final SplittableRandom random = new SplittableRandom(9);
    private final Portals portals = threePairs();

    /** Returns three pairs: 0–3, 1–4, 2–5. */
    private static Portals threePairs() {
        List<Portal> all = new ArrayList<>();
        List<Integer> partners = new ArrayList<>();
        for (int i = 0; i < LETTERS; i++) {
            var aperture = Aperture.of(PortalShape.RECTANGLE, 1, 2);
            all.add(new Portal("p" + i, new Vec3(i, 0, 0), Basis.WORLD, aperture));
            partners.add((i + 3) % LETTERS);
        }
        return new Portals(all, partners);
    }

    private int[] letters(int most) {
        return random.ints(random.nextInt(most + 1), 0, LETTERS).toArray();
    }

    private CrossingWord then(CrossingWord word, int... letters) {
        CrossingWord longer = word;
        for (int letter : letters) {
            longer = longer.then(letter, portals);
        }
        return longer;
    }

    private int[] inverse(int... letters) {
        int[] inverse = new int[letters.length];
        for (int i = 0; i < letters.length; i++) {
            inverse[i] = portals.partner(letters[letters.length - 1 - i]);
        }
        return inverse;
    }

    @Test
    void aWordIsReduced() {
        for (int i = 0; i < 2000; i++) {
            CrossingWord word = then(CrossingWord.EMPTY, letters(12));
            for (int j = 1; j < word.length(); j++) {
                assertNotEquals(portals.partner(word.entry(j - 1)), word.entry(j));
            }
        }
    }

    @Test
    void thereAndBackIsNothing() {
        for (int i = 0; i < 2000; i++) {
            int[] way = letters(12);
            CrossingWord before = then(CrossingWord.EMPTY, letters(12));
            assertEquals(before, then(then(before, way), inverse(way)));
        }
        assertEquals(1, then(CrossingWord.EMPTY, 2).length());
        assertEquals(2, then(CrossingWord.EMPTY, 2, 2).length());
    }

    /** The word between two ends is the same for any order in which they go through portals. */
    @Test
    void bothEndsMayMoveInAnyOrder() {
        for (int i = 0; i < 2000; i++) {
            CrossingWord start = then(CrossingWord.EMPTY, letters(6));
            int[] player = letters(6);
            int[] body = letters(6);
            CrossingWord playerFirst = then(afterEntering(start, player), body);
            CrossingWord bodyFirst = afterEntering(then(start, body), player);
            assertEquals(playerFirst, bodyFirst);
            assertEquals(playerFirst.hashCode(), bodyFirst.hashCode());
            assertEquals(bodyFirst, interleaved(start, player, body));
        }
    }

    private CrossingWord afterEntering(CrossingWord word, int... letters) {
        CrossingWord rest = word;
        for (int letter : letters) {
            rest = rest.afterEntering(letter, portals);
        }
        return rest;
    }

    private CrossingWord interleaved(CrossingWord start, int[] player, int[] body) {
        CrossingWord word = start;
        int p = 0;
        int b = 0;
        while (p < player.length || b < body.length) {
            boolean playerMoves = b == body.length || p < player.length && random.nextBoolean();
            word = playerMoves ? word.afterEntering(player[p++], portals) : word.then(body[b++], portals);
        }
        return word;
    }

    /** If one end follows the other through the same portals, the word between them is empty. */
    @Test
    void whoFollowsArrives() {
        for (int i = 0; i < 2000; i++) {
            int[] way = letters(12);
            assertEquals(CrossingWord.EMPTY, afterEntering(then(CrossingWord.EMPTY, way), way));
        }
    }

    @Test
    void differentWordsDiffer() {
        assertNotEquals(then(CrossingWord.EMPTY, 0, 1), then(CrossingWord.EMPTY, 1, 0));
        assertNotEquals(then(CrossingWord.EMPTY, 0), CrossingWord.EMPTY);
        assertNotEquals(CrossingWord.EMPTY, null);
        assertTrue(then(CrossingWord.EMPTY, 0, 1).toString().contains("0, 1"));
    }
}
