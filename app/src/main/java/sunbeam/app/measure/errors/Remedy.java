package sunbeam.app.measure.errors;

import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Sentence;

/**
 * Something to do about a missed tolerance.
 *
 * @param words what to do: "leave out --terms"
 * @param choices what is chosen then
 */
record Remedy(Sentence words, Choices choices) {}
