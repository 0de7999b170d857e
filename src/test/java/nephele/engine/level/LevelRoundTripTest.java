package nephele.engine.level;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;
import java.util.stream.Stream;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.json.LevelJsonTest;
import nephele.engine.level.json.NumberText;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Load(save(x)) is x to the bit, in any locale; record equality compares doubles by their bits. */
@Isolated
class LevelRoundTripTest {
    @ParameterizedTest
    @ValueSource(strings = {"en-GB", "de-DE", "ar-EG-u-nu-arab", "tr-TR"})
    void whatWasWrittenReadsBackBitEqual(String tag) {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.forLanguageTag(tag));
            RandomLevels levels = new RandomLevels(tag.hashCode());
            Stream.generate(levels::next).limit(120).toList().parallelStream().forEach(level -> {
                String text = LevelJson.write(level);
                Level again = LevelJsonTest.read(text);
                assertEquals(level, again);
                assertEquals(text, LevelJson.write(again));
            });
        } finally {
            Locale.setDefault(before);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"de-DE", "ar-EG-u-nu-arab", "tr-TR"})
    void theLocaleChangesNothing(String tag) {
        Locale before = Locale.getDefault();
        Level level = LevelJsonTest.read(LevelJsonTest.PUFF);
        String text = LevelJson.write(level);
        try {
            Locale.setDefault(Locale.forLanguageTag(tag));
            assertEquals("-1234.5", NumberText.of(-1234.5));
            assertEquals(text, LevelJson.write(level));
            assertEquals(level, LevelJsonTest.read(text));
            assertEquals(
                    "solids[0].size[0]: must be from 0.0001 to 10000000, not -0.5",
                    LevelJsonTest.problems(
                                    "{\"format\": \"nephele-level\", \"version\": 1, \"solids\": [{\"id\": \"i\","
                                            + " \"kind\": \"box\", \"centre\": [0, 0, 0], \"size\": [-0.5, 1, 1]}]}")
                            .get(0)
                            .line("f")
                            .substring(3));
        } finally {
            Locale.setDefault(before);
        }
    }

    /** The order of keys and the layout are part of the format: a diff shows only the author's changes. */
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
