package nephele.engine.asset;

/** An unusable asset: its id, the reason, and the remedy for its author. */
public final class AssetException extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final String assetId;
    private final String reason;
    private final String remedy;

    public AssetException(String assetId, String reason, String remedy) {
        this(assetId, reason, remedy, null);
    }

    public AssetException(String assetId, String reason, String remedy, Throwable cause) {
        super(MessageText.shortened(assetId) + ": " + MessageText.shortened(reason) + "; " + remedy, cause);
        this.assetId = assetId;
        this.reason = reason;
        this.remedy = remedy;
    }

    public String assetId() {
        return assetId;
    }

    public String reason() {
        return reason;
    }

    public String remedy() {
        return remedy;
    }
}
