package nephele.editor.file;

import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneId;
import java.time.ZonedDateTime;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import nephele.editor.text.Words;

/** Times as people say them: {@code today 14:02}. */
final class TimeWords {
    private static final DateTimeFormatter CLOCK = DateTimeFormatter.ofPattern("HH:mm", Locale.ROOT);
    private static final DateTimeFormatter ENGLISH = DateTimeFormatter.ofPattern("d MMMM uuuu, HH:mm", Locale.ENGLISH);
    private static final DateTimeFormatter PORTUGUESE =
            DateTimeFormatter.ofPattern("d 'de' MMMM 'de' uuuu, HH:mm", Locale.forLanguageTag("pt"));

    private TimeWords() {}

    static Words of(Instant time, Instant now, ZoneId zone) {
        ZonedDateTime local = time.atZone(zone);
        LocalDate today = now.atZone(zone).toLocalDate();
        if (local.toLocalDate().equals(today)) {
            return FileText.TODAY.with(CLOCK.format(local));
        }
        if (local.toLocalDate().equals(today.minusDays(1))) {
            return FileText.YESTERDAY.with(CLOCK.format(local));
        }
        String portuguese = PORTUGUESE.format(local);
        return Words.of(ENGLISH.format(local), portuguese, portuguese);
    }
}
