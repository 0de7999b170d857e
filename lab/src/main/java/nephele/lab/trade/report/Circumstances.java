package nephele.lab.trade.report;

/**
 * Where and how a report was made, in words.
 *
 * @param picture size, rays of the oracle, camera
 */
public record Circumstances(
        String level, String levelFile, String picture, String machine, String graphics, String commit, String date) {}
