package nephele.app.play.hud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Pages are made for 640 × 360 points: no window shows fewer, however small it is or fine its screen. */
class AreaTest {
    @ParameterizedTest
    @CsvSource({
        "640, 360, 1, 640, 360",
        "1280, 720, 1, 1280, 720",
        "1280, 720, 2, 640, 360",
        "3840, 2160, 1, 1920, 1080",
        "3840, 2160, 2, 1920, 1080",
        "640, 360, 2, 640, 360",
        "320, 180, 1, 640, 360",
        "160, 360, 1, 640, 1440",
        "720, 1280, 1, 640, 1137.8",
        "300, 1, 1, 108000, 360"
    })
    void noWindowShowsLessThanThePagesNeed(int width, int height, double scale, double wide, double high) {
        Area area = Area.of(width, height, scale);
        assertEquals(wide, area.width(), 0.05);
        assertEquals(high, area.height(), 0.05);
        assertTrue(area.width() >= 640 - 1e-9 && area.height() >= 360 - 1e-9, area.toString());
    }
}
