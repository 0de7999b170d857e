package nephele.lab.trade;

/**
 * One value of a subject's parameter.
 *
 * @param name as typed in a command or shown in the report, unique within its subject
 * @param note its effect, for a reader of the report; may be empty
 */
public record Setting(String name, String note) {
    public static Setting of(String name) {
        return new Setting(name, "");
    }
}
