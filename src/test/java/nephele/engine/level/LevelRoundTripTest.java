package nephele.engine.level;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Load(save(x)) is x to the bit, in any locale; record equality compares doubles by their bits. */
class LevelRoundTripTest {
    @ParameterizedTest
    @ValueSource(strings = {"en-GB", "de-DE", "ar-EG-u-nu-arab", "tr-TR"})
    void whatWasWrittenReadsBackBitEqual(String tag) {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.forLanguageTag(tag));
            RandomLevels levels = new RandomLevels(tag.hashCode());
            for (int i = 0; i < 120; i++) {
                Level level = levels.next();
                String text = LevelJson.write(level);
                Level again = LevelJsonTest.read(text);
                assertEquals(level, again);
                assertEquals(text, LevelJson.write(again));
            }
        } finally {
            Locale.setDefault(before);
        }
    }

    /** The order of keys and the layout are part of the format: a diff shows what an author changed and nothing else. */
    @Test
    void theLayoutIsCanonical() {
        String text =
                """
                {
                  "format": "nephele-level",
                  "version": 1,
                  "name": "n",
                  "environment": {
                    "sun": {
                      "directionTowardsSun": [0, 1, 0.5],
                      "irradiance": [1, 1, 1]
                    }
                  },
                  "solids": [
                    {
                      "id": "floor",
                      "kind": "box",
                      "material": "m",
                      "centre": [0, -0.5, 0],
                      "size": [10, 1, 10],
                      "faces": {
                        "+y": {
                          "portalable": true
                        }
                      }
                    }
                  ]
                }
                """;
        assertEquals(text, LevelJson.write(LevelJsonTest.read(text)));
    }
}
