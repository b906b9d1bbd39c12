/**
 * Contract with users and scripts, independent of the implementation: values of maps, lists, pictures and periods, scans, exit codes and
 * messages about bad input. Few and fast tests.
 */
package sunbeam.acceptance.contract;
