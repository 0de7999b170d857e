package nephele.lab.trade;

/**
 * One position of a knob.
 *
 * @param name as it is typed or said, unique within its subject
 * @param note what it does, for who has to choose; may be empty
 */
public record Setting(String name, String note) {
    public static Setting of(String name) {
        return new Setting(name, "");
    }
}
